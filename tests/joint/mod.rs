mod certificates;
mod gauge;
mod radius;
