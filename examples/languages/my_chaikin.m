function refined = my_chaikin(points, levels)
%MY_CHAIKIN Refine a closed polygon, one point in each row, by Chaikin's scheme.
  refined = points;
  for level = 1:levels
    next = circshift(refined, -1, 1);
    corners = zeros(2 * size(refined, 1), size(refined, 2));
    corners(1:2:end, :) = 0.75 * refined + 0.25 * next;
    corners(2:2:end, :) = 0.25 * refined + 0.75 * next;
    refined = corners;
  end
end
