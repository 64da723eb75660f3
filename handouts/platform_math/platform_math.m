% sin, cos, exp and log as this MATLAB or Octave has them: FOLDER/sin.txt to
% FOLDER/sin.out, and so on. FOLDER is the environment's PLATFORM_MATH.

folder = getenv('PLATFORM_MATH');
functions = {@sin, @cos, @exp, @log};
for i = 1:numel(functions)
  name = func2str(functions{i});
  name = name(name ~= '@');
  file = fopen(fullfile(folder, [name, '.txt']), 'r');
  arguments = sscanf(fread(file, [1, Inf], '*char'), '%f');
  fclose(file);
  file = fopen(fullfile(folder, [name, '.out']), 'w');
  fprintf(file, '%.17g\n', functions{i}(arguments));
  fclose(file);
end
