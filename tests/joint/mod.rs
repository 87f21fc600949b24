mod certificates;
mod radius;
