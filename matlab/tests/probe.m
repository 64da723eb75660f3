function probe(name, input, output)
    % PROBE  Lay open what the contract is made of, for tests of all ports.
    %
    %   probe(name, input, output)
    %
    %   name: sin, cos, exp, log, philox or bresenham; input, output: files,
    %   one line per call (see CONTRIBUTING.md).
    file = fopen(input, 'r');
    assert(file >= 0, 'cannot read %s', input);
    text = fread(file, [1, Inf], 'uint8=>char');
    fclose(file);

    switch name
        case {'sin', 'cos', 'exp', 'log'}
            x = hex2num(words(text, 16));
            switch name
                case 'sin'
                    y = occgrid.portable_math.sin(x);
                case 'cos'
                    y = occgrid.portable_math.cos(x);
                case 'exp'
                    y = occgrid.portable_math.exp(x);
                otherwise
                    y = occgrid.portable_math.log(x);
            end
            lines = num2hex(y);
            lines(isnan(y), :) = repmat('7ff8000000000000', sum(isnan(y)), 1);
        case 'philox'
            in = reshape(hex2dec(words(text, 8)), 6, []);
            out = occgrid.noise.philox4x32(in(1:4, :), in(5:6, :));
            lines = lower(reshape(dec2hex(out, 8)', 32, [])');
            lines = [lines(:, 1:8), blanks_of(lines), lines(:, 9:16), ...
                     blanks_of(lines), lines(:, 17:24), ...
                     blanks_of(lines), lines(:, 25:32)];
        case 'bresenham'
            in = reshape(sscanf(text, '%f'), 4, []);
            lines = cell(size(in, 2), 1);
            for i = 1:size(in, 2)
                [gx, gy] = occgrid.ray.bresenham( ...
                    in(1, i), in(2, i), in(3, i), in(4, i));
                cells = sprintf('%d,%d ', [gx(:)'; gy(:)']);
                lines{i} = cells(1:end - 1);
            end
        otherwise
            error('no function %s', name);
    end

    if ~iscell(lines)
        lines = cellstr(lines);
    end
    file = fopen(output, 'w');
    assert(file >= 0, 'cannot write %s', output);
    fprintf(file, '%s\n', lines{:});
    fclose(file);
end

function w = words(text, digits)
    % the text's words of so many hexadecimal digits, a row each
    w = reshape(text(isstrprop(text, 'xdigit')), digits, [])';
end

function b = blanks_of(lines)
    b = repmat(' ', size(lines, 1), 1);
end
