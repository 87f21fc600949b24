mod certificates;
mod gauge;
mod radius;
mod reduction;
