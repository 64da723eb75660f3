% The lesson's angles as a MATLAB programmer writes them: 181 bearings by
% linspace, then 120 turns along the ellipse with the index counted from 1.

printf('%.17g\n', linspace(-pi / 2, pi / 2, 181));
for t = 1:120
  printf('%.17g\n', 2 * pi * (t - 1) / 120);
end
