classdef log_lines
    % LOG_LINES  The lines of a log, their fields, and fields as numbers.
    %
    %   [text, rest, ended] = occgrid.log_lines.next_lines(id, rest)
    %   c = occgrid.log_lines.fields(text)
    %   v = occgrid.log_lines.values(text, c, f, g)
    %   [v, bad] = occgrid.log_lines.numbers(text, c, f, g)
    %   [value, bad] = occgrid.log_lines.one_number(token)
    %
    %   Many lines are taken apart at once, as arrays of characters: one by
    %   one they would cost an interpreter most of its time.

    methods (Static)

        function [text, rest, ended] = next_lines(id, rest)
            % NEXT_LINES  Some whole lines, each with its LF, of an open file.
            %
            %   rest: what was read beyond them. ended: whether these are the
            %   last ones. (fgetl is not used: Octave's takes a single CR for
            %   the end of a line.)
            parts = {rest};
            rest = '';
            size_ = 65536;
            while true
                text = fread(id, [1, size_], 'uint8=>char');
                ended = isempty(text);
                last = find(text == newline, 1, 'last');
                parts{end + 1} = text; %#ok<AGROW>
                if ended
                    text = [parts{:}];
                    if ~isempty(text)
                        text(end + 1) = newline;
                    end
                    return
                elseif ~isempty(last)
                    rest = text(last + 1:end);
                    parts{end} = text(1:last);
                    text = [parts{:}];
                    return
                end
                size_ = 2 * size_; % a very long line
            end
        end

        function c = fields(text)
            % FIELDS  Where the fields of whole lines are, and what is odd.
            %
            %   first, last   per line: its fields; none where last < first
            %   not_plain     per line: has a byte that is not plain ASCII
            %   candidates    the lines to look at: neither blank nor comment,
            %                 and wrong or with a keyword that may be ours
            %   starts, ends  per field: its place in text
            %   not_word      per field: cannot be a keyword
            %   odd           per field: not a number of the simplest form,
            %                 [-] digits [. digits], which is read quickly
            d = double(text);
            lf = d == 10;
            line_ends = find(lf);
            space = d == 32 | d == 9 | lf;
            space(line_ends(d(max(line_ends - 1, 1)) == 13) - 1) = true;
            edges = diff([true, space, true]);
            c.starts = find(edges == -1);
            c.ends = find(edges == 1) - 1;
            field = cumsum(edges == -1);
            c.last = field(line_ends);
            c.first = [0, c.last(1:end - 1)] + 1;
            n = numel(c.starts);
            line = cumsum([1, lf]);

            c.not_plain = false(size(line_ends));
            c.not_plain(line((d < 32 & ~space) | d > 126)) = true;

            digit = d >= 48 & d <= 57;
            letter = (d >= 65 & d <= 90) | (d >= 97 & d <= 122) | d == 95;
            c.not_word = false(1, n);
            c.not_word(field(~(digit | letter | space))) = true;
            c.not_word(digit(c.starts)) = true;

            minus = d == 45;
            dot = d == 46;
            after = [digit(2:end) | dot(2:end), false];
            wrong = ~(digit | minus | dot | space) | (minus & ~after);
            wrong = wrong | (dot & ~[false, digit(1:end - 1)] & ...
                             ~[digit(2:end), false]);
            wrong = wrong | (minus & ~[true, space(1:end - 1)]);
            c.odd = false(1, n);
            c.odd(field(wrong)) = true;
            dots = field(dot);
            c.odd(dots([false, diff(dots) == 0])) = true;

            c.candidates = [];
            if n == 0
                return
            end
            some = find(c.last >= c.first);
            head = d(c.starts(c.first(some)));
            ours = any(head == ('PWFR')', 1);
            look = ours | c.not_plain(some) | c.not_word(c.first(some));
            c.candidates = some(look & head ~= '#');
        end

        function v = values(text, c, f, g)
            % VALUES  The fields after the keyword, up to a comment.
            v = cell(1, g - f);
            for i = 1:g - f
                v{i} = text(c.starts(f + i):c.ends(f + i));
                if v{i}(1) == '#'
                    v = v(1:i - 1);
                    break
                end
            end
        end

        function [v, bad] = numbers(text, c, f, g)
            % NUMBERS  The fields f to g as numbers (n, 1), and which are none.
            %
            %   All fields are read at once. Those that are not of the
            %   simplest form are read one by one, and stand as 0 meanwhile.
            odd = find(c.odd(f:g));
            part = text(c.starts(f):c.ends(g));
            special = zeros(numel(odd), 1);
            bad = false(g - f + 1, 1);
            token = '';
            for i = 1:numel(odd)
                a = c.starts(f + odd(i) - 1);
                b = c.ends(f + odd(i) - 1);
                if ~strcmp(token, text(a:b)) % NaN often follows NaN
                    token = text(a:b);
                    [value, wrong] = occgrid.log_lines.one_number(token);
                end
                special(i) = value;
                bad(odd(i)) = wrong;
                part(a - c.starts(f) + 1:b - c.starts(f) + 1) = ' ';
                part(a - c.starts(f) + 1) = '0';
            end
            v = sscanf(part, '%f');
            v(odd) = special;
            v(v >= 1e300) = Inf;
            v(v <= -1e300) = -Inf;
            v(abs(v) < 1e-300) = 0;
        end

        function [value, bad] = one_number(token)
            % ONE_NUMBER  A number of SPEC.md section 5.1, or that it is none.
            value = 0;
            bad = isempty(regexp(token, ...
                ['^[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)' ...
                 '([eE][+-]?[0-9]+)?$'], 'once'));
            if ~bad
                value = sscanf(token, '%f');
            elseif ~isempty(regexpi(token, ...
                                    '^[+-]?(nan|inf|infinity)$', 'once'))
                bad = false;
                value = Inf;
                if any(lower(token) == 'a')
                    value = NaN;
                elseif token(1) == '-'
                    value = -Inf;
                end
            end
        end

    end
end
