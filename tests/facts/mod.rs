mod brute;
mod known;
mod slow;
