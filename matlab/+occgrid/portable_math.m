classdef portable_math
    % PORTABLE_MATH  sin, cos, exp, log with the same bits on every machine.
    %
    %   s = occgrid.portable_math.sin(x)
    %   c = occgrid.portable_math.cos(x)
    %   y = occgrid.portable_math.exp(x)
    %   y = occgrid.portable_math.log(x)
    %
    %   The algorithms are those of fdlibm 5.3 (Sun Microsystems, 1993-1995),
    %   which Java's StrictMath is specified to be; SPEC.md section 9 writes
    %   them down. The built-in functions are the platform's own, with other
    %   last bits on other machines.
    %
    %   pi needs no definition here: the built-in pi is the double nearest to
    %   the number, 0x400921FB54442D18.
    %
    %   All four take an array of any shape, accept every double, and return
    %   an array of that shape.

    methods (Static)

        % [snippet: portable-sin]
        function s = sin(x)
            % SIN  Sine of x (radians); NaN where x is infinite or NaN.
            [n, y0, y1] = occgrid.portable_math.rem_pio2(x(:));
            reduced = y0 ~= x(:);
            s = occgrid.portable_math.kernel_sin(y0, y1, reduced);
            c = occgrid.portable_math.kernel_cos(y0, y1);
            n = mod(n, 4);
            odd = n == 1 | n == 3;
            s(odd) = c(odd);
            s(n >= 2) = -s(n >= 2);
            s = reshape(s, size(x));
        end

        function c = cos(x)
            % COS  Cosine of x (radians); NaN where x is infinite or NaN.
            [n, y0, y1] = occgrid.portable_math.rem_pio2(x(:));
            reduced = y0 ~= x(:);
            s = occgrid.portable_math.kernel_sin(y0, y1, reduced);
            c = occgrid.portable_math.kernel_cos(y0, y1);
            n = mod(n, 4);
            odd = n == 1 | n == 3;
            c(odd) = s(odd);
            turned = n == 1 | n == 2;
            c(turned) = -c(turned);
            c = reshape(c, size(x));
        end

        function s = kernel_sin(x, y, reduced)
            % KERNEL_SIN  sin(x + y) for |x| <= pi/4.
            %
            %   x, y, reduced: (n, 1); y is the tail of a reduced x.
            persistent S1 S2 S3 S4 S5 S6
            if isempty(S6)
                S1 = hex2num('BFC5555555555549');
                S2 = hex2num('3F8111111110F8A6');
                S3 = hex2num('BF2A01A019C161D5');
                S4 = hex2num('3EC71DE357B1FE7D');
                S5 = hex2num('BE5AE5E68A2B9CEB');
                S6 = hex2num('3DE5D93A5ACFD57C');
            end
            z = x .* x;
            v = z .* x;
            r = S2 + z .* (S3 + z .* (S4 + z .* (S5 + z .* S6)));
            s = x + v .* (S1 + z .* r);
            tailed = x - ((z .* (0.5 .* y - v .* r) - y) - v .* S1);
            s(reduced) = tailed(reduced);
            tiny = abs(x) < 2^-27;
            s(tiny) = x(tiny);
        end

        function c = kernel_cos(x, y)
            % KERNEL_COS  cos(x + y) for |x| <= pi/4; y is the tail of x.
            %
            %   x, y: (n, 1).
            persistent C1 C2 C3 C4 C5 C6 small large
            if isempty(large)
                C1 = hex2num('3FA555555555554C');
                C2 = hex2num('BF56C16C16C15177');
                C3 = hex2num('3EFA01A019CB1590');
                C4 = hex2num('BE927E4F809C52AD');
                C5 = hex2num('3E21EE9EBDB4B1C4');
                C6 = hex2num('BDA8FAE9BE8838D4');
                small = hex2dec('3FD33333');
                large = hex2dec('3FE90000');
            end
            high = occgrid.portable_math.high_word(abs(x));
            z = x .* x;
            r = C3 + z .* (C4 + z .* (C5 + z .* C6));
            r = z .* (C1 + z .* (C2 + z .* r));
            % about x/4, so that 1 - qx is exact and little is lost in hz
            qx = occgrid.portable_math.from_words(max(high - 2^21, 0), 0);
            qx(high > large) = 0.28125;
            qx(high < small) = 0;
            hz = 0.5 .* z - qx;
            c = (1 - qx) - (hz - (z .* r - x .* y));
            c(abs(x) < 2^-27) = 1;
        end

        % [/snippet]

        % [snippet: portable-exp]
        function y = exp(x)
            % EXP  e to the power x; infinity above 709.78, 0 below -745.13.
            persistent ln2_hi ln2_lo inv_ln2 P1 P2 P3 P4 P5
            persistent overflow underflow half_ln2 near_ln2 tiny
            if isempty(tiny)
                ln2_hi = hex2num('3FE62E42FEE00000');
                ln2_lo = hex2num('3DEA39EF35793C76');
                inv_ln2 = hex2num('3FF71547652B82FE');
                P1 = hex2num('3FC555555555553E');
                P2 = hex2num('BF66C16C16BEBD93');
                P3 = hex2num('3F11566AAF25DE2C');
                P4 = hex2num('BEBBBD41C5D26BF1');
                P5 = hex2num('3E66376972BEA4D0');
                overflow = hex2num('40862E42FEFA39EF');
                underflow = hex2num('C0874910D52D3051');
                half_ln2 = hex2dec('3FD62E42');
                near_ln2 = hex2dec('3FF0A2B2');
                tiny = hex2dec('3E300000');
            end
            arg = x(:);
            arg(~(arg <= overflow & arg >= underflow)) = 0;
            high = occgrid.portable_math.high_word(abs(arg));
            sign_ = 1 - 2 .* (arg < 0);
            % arg = k ln 2 + (hi - lo)
            k = fix(inv_ln2 .* arg + 0.5 .* sign_);
            near = high < near_ln2;
            k(near) = sign_(near);
            k(high <= half_ln2) = 0;
            hi = arg - k .* ln2_hi;
            lo = k .* ln2_lo;
            r = hi - lo;
            t = r .* r;
            c = P2 + t .* (P3 + t .* (P4 + t .* P5));
            c = r - t .* (P1 + t .* c);
            y = 1 - ((lo - (r .* c) ./ (2 - c)) - hi);
            % times 2^k through the exponent field; a result that may be
            % subnormal in two steps
            deep = k < -1021;
            k = k + 1000 .* deep;
            words = occgrid.portable_math.high_word(y) + k .* 2^20;
            y = occgrid.portable_math.from_words( ...
                words, occgrid.portable_math.low_word(y));
            y(deep) = y(deep) .* 2^-1000;
            whole = 1 - ((r .* c) ./ (c - 2) - r);
            y(k == 0) = whole(k == 0);
            y(high < tiny) = 1 + arg(high < tiny);
            y(x(:) > overflow) = Inf;
            y(x(:) < underflow) = 0;
            y(isnan(x(:))) = NaN;
            y = reshape(y, size(x));
        end

        % [/snippet]

        % [snippet: portable-log]
        function y = log(x)
            % LOG  Natural logarithm; -infinity at 0, NaN below it.
            persistent ln2_hi ln2_lo Lg1 Lg2 Lg3 Lg4 Lg5 Lg6 Lg7
            persistent third sqrt2 middle_low middle_high
            if isempty(middle_high)
                ln2_hi = hex2num('3FE62E42FEE00000');
                ln2_lo = hex2num('3DEA39EF35793C76');
                Lg1 = hex2num('3FE5555555555593');
                Lg2 = hex2num('3FD999999997FA04');
                Lg3 = hex2num('3FD2492494229359');
                Lg4 = hex2num('3FCC71C51D8E78AF');
                Lg5 = hex2num('3FC7466496CB03DE');
                Lg6 = hex2num('3FC39A09D078C69F');
                Lg7 = hex2num('3FC2F112DF3E5244');
                third = hex2num('3FD5555555555555');
                sqrt2 = 2^20 - hex2dec('95F64');
                middle_low = hex2dec('6147A');
                middle_high = hex2dec('6B851');
            end
            arg = x(:);
            arg(~(arg > 0 & arg < Inf)) = 1;
            tiny = arg < 2^-1022;
            arg(tiny) = arg(tiny) .* 2^54;
            % arg = 2^k (1 + f) with 1 + f between sqrt(1/2) and sqrt(2)
            high = occgrid.portable_math.high_word(arg);
            k = floor(high ./ 2^20) - 1023 - 54 .* tiny;
            high = mod(high, 2^20);
            above = high >= sqrt2;
            k = k + above;
            words = high + (1023 - above) .* 2^20;
            f = occgrid.portable_math.from_words( ...
                words, occgrid.portable_math.low_word(arg)) - 1;
            hi = k .* ln2_hi;
            lo = k .* ln2_lo;
            zero = k == 0;

            s = f ./ (2 + f);
            z = s .* s;
            w = z .* z;
            t1 = w .* (Lg2 + w .* (Lg4 + w .* Lg6));
            t2 = z .* (Lg1 + w .* (Lg3 + w .* (Lg5 + w .* Lg7)));
            r = t2 + t1;
            y = hi - ((s .* (f - r) - lo) - f);
            whole = f - s .* (f - r);
            y(zero) = whole(zero);

            half = 0.5 .* f .* f;
            part = hi - ((half - (s .* (half + r) + lo)) - f);
            whole = f - (half - s .* (half + r));
            part(zero) = whole(zero);
            middle = high >= middle_low & high <= middle_high;
            y(middle) = part(middle);

            r = f .* f .* (0.5 - third .* f);
            part = hi - ((r - lo) - f);
            whole = f - r;
            part(zero) = whole(zero);
            part(f == 0) = hi(f == 0) + lo(f == 0);
            small = mod(2 + high, 2^20) < 3; % |f| < 2^-20
            y(small) = part(small);

            y(x(:) == 0) = -Inf;
            y(x(:) == Inf) = Inf;
            y(x(:) < 0 | isnan(x(:))) = NaN;
            y = reshape(y, size(x));
        end

        % [/snippet]

    end

    methods (Static, Access = private)

        % --- Reduction to [-pi/4, pi/4] ---

        function [n, y0, y1] = rem_pio2(x)
            % n, y0, y1 with x = n*pi/2 + y0 + y1 and |y0 + y1| <= pi/4;
            % n = 0 and y0 = x where x is so small itself. All (n, 1).
            persistent inv_pio2 part1 tail1 part2 tail2 part3 tail3
            persistent npio2_high pi_4 three_pi_4 medium infinite
            if isempty(infinite)
                inv_pio2 = hex2num('3FE45F306DC9C883');
                part1 = hex2num('3FF921FB54400000');
                tail1 = hex2num('3DD0B4611A626331');
                part2 = hex2num('3DD0B4611A600000');
                tail2 = hex2num('3BA3198A2E037073');
                part3 = hex2num('3BA3198A2E000000');
                tail3 = hex2num('397B839A252049C1');
                % upper words of n*pi/2: near them the first subtraction
                % cancels and more of pi/2 is needed
                npio2_high = occgrid.portable_math.high_word( ...
                    (1:32)' .* hex2num('3FF921FB54442D18'));
                % upper words of the limits between the cases
                pi_4 = hex2dec('3FE921FB');
                three_pi_4 = hex2dec('4002D97C');
                medium = hex2dec('413921FB');
                infinite = hex2dec('7FF00000');
            end
            n = zeros(size(x));
            y0 = x;
            y1 = zeros(size(x));
            high = occgrid.portable_math.high_word(abs(x));

            i = find(high > pi_4 & high <= medium);
            magnitude = abs(x(i));
            below_3pi4 = high(i) < three_pi_4;
            fn = floor(magnitude .* inv_pio2 + 0.5);
            fn(below_3pi4) = 1;
            r = magnitude - fn .* part1;
            w = fn .* tail1;
            y = r - w;
            % close to a multiple of pi/2 the subtraction cancels: go on
            % with the second part of pi/2, and the third
            close_ = fn >= 32 | npio2_high(min(fn, 32)) == high(i);
            lost = floor(high(i) ./ 2^20) - occgrid.portable_math.exponent(y);
            j = find(close_ & (below_3pi4 | lost > 16));
            if ~isempty(j)
                [r(j), w(j)] = occgrid.portable_math.subtract_part( ...
                    r(j), fn(j), part2, tail2);
                y(j) = r(j) - w(j);
                lost = floor(high(i(j)) ./ 2^20) - ...
                    occgrid.portable_math.exponent(y(j));
                j = j(~below_3pi4(j) & lost > 49);
                [r(j), w(j)] = occgrid.portable_math.subtract_part( ...
                    r(j), fn(j), part3, tail3);
                y(j) = r(j) - w(j);
            end
            sign_ = 1 - 2 .* (x(i) < 0);
            n(i) = sign_ .* fn;
            y0(i) = sign_ .* y;
            y1(i) = sign_ .* ((r - y) - w);

            i = find(high > medium & high < infinite);
            if ~isempty(i)
                [n(i), y0(i), y1(i)] = ...
                    occgrid.portable_math.reduce_huge(x(i), 4);
            end
            y0(high >= infinite) = NaN;
        end

        function [r, w] = subtract_part(r, n, part, tail)
            % the next part of pi/2 subtracted n times, and its tail
            before = r;
            w = n .* part;
            r = before - w;
            w = n .* tail - ((before - r) - w);
        end

        function [n, y0, y1] = reduce_huge(x, jz)
            % rem_pio2 for |x| above 2^20*pi/2 (Payne and Hanek's method):
            % only those digits of 2/pi are multiplied that matter for the
            % fraction of x*2/pi. jz: the number of its digits, 4 or, for an
            % x very close to a multiple of pi/2, more.
            persistent two_over_pi pio2_split
            if isempty(pio2_split)
                two_over_pi = hex2dec(reshape([ ...
                    'A2F9836E4E441529FC2757D1F534DDC0DB6295993C439041' ...
                    'FE5163ABDEBBC561B7246E3A424DD2E006492EEA09D1921C' ...
                    'FE1DEB1CB129A73EE88235F52EBB4484E99C7026B45F7E41' ...
                    '3991D639835339F49C845F8BBDF9283B1FF897FFDE05980F' ...
                    'EF2F118B5A0A6D1F6D367ECF27CB09B74F463F669E5FEA2D' ...
                    '7527BAC7EBE5F17B3D0739F78A5292EA6BFB5FB11F8D5D08' ...
                    '56033046FC7B6BABF0CFBC209AF4361DA9E391615EE61B08' ...
                    '6599855F14A068408DFFD8804D73273106061556CA73A8C9' ...
                    '60E27BC08C6B'], 6, [])');
                two_over_pi = [0; 0; two_over_pi]; % digits -2 and -1 are 0
                pio2_split = hex2num({ ...
                    '3FF921FB40000000'; '3E74442D00000000'
                    '3CF8469880000000'; '3B78CC5160000000'
                    '39F01B8380000000'});
            end
            two24 = 2^24;

            % |x| = z * 2^e0 with z of three digits of 24 bits
            e0 = occgrid.portable_math.exponent(x) - 1046;
            z = abs(x) .* occgrid.portable_math.power_of_2(-e0);
            tx = zeros(numel(x), 3);
            tx(:, 1) = floor(z);
            z = (z - tx(:, 1)) .* two24;
            tx(:, 2) = floor(z);
            tx(:, 3) = (z - tx(:, 2)) .* two24;
            jv = max(fix((e0 - 3) ./ 24), 0);
            q0 = e0 - 24 .* (jv + 1);
            q = zeros(numel(x), jz + 1);
            for i = 0:jz
                for j = 0:2
                    digit = reshape(two_over_pi(jv + i - j + 3), [], 1);
                    q(:, i + 1) = q(:, i + 1) + tx(:, j + 1) .* digit;
                end
            end

            % distil the columns q into digits, the least first
            iq = zeros(numel(x), jz + 2);
            z = q(:, jz + 1);
            for i = 1:jz
                fw = floor(z ./ two24);
                iq(:, i) = z - fw .* two24;
                z = q(:, jz + 1 - i) + fw;
            end
            z = z .* occgrid.portable_math.power_of_2(q0);
            z = z - 8 .* floor(z ./ 8);
            n = floor(z);
            z = z - n;
            % the top digit has the last q0 bits of n
            whole = occgrid.portable_math.power_of_2(24 - max(q0, 0));
            top = floor(iq(:, jz) ./ whole);
            n = n + top;
            iq(:, jz) = iq(:, jz) - top .* whole;
            over_half = iq(:, jz) >= whole ./ 2;
            over_half(q0 < 0) = z(q0 < 0) >= 0.5;

            % more than half a quarter turn: one more, and what is missing
            n = n + over_half;
            seen = cumsum(iq ~= 0, 2);
            first = seen == 1 & iq ~= 0;
            rest = seen > 0 & ~first;
            rest(:, jz + 1:end) = false;
            first(~over_half, :) = false;
            rest(~over_half, :) = false;
            iq(first) = two24 - iq(first);
            iq(rest) = two24 - 1 - iq(rest);
            iq(:, jz) = mod(iq(:, jz), whole);
            j = over_half & q0 < 0;
            z(j) = 1 - z(j);
            j = j & any(first, 2);
            z(j) = z(j) - occgrid.portable_math.power_of_2(q0(j));

            % the fraction above the digits is one or two digits more
            above = z .* occgrid.portable_math.power_of_2(-q0);
            iq(:, jz + 2) = floor(above ./ two24);
            iq(:, jz + 1) = above - iq(:, jz + 2) .* two24;
            scaled = zeros(numel(x), jz + 2 + 4);
            fq = zeros(numel(x), jz + 2);
            for i = 0:jz + 1
                weight = occgrid.portable_math.power_of_2( ...
                    q0 - 24 .* (jz - i));
                scaled(:, i + 1) = iq(:, i + 1) .* weight;
            end
            for i = 0:jz + 1
                for k = 0:4
                    fq(:, i + 1) = fq(:, i + 1) + ...
                        pio2_split(k + 1) .* scaled(:, i + k + 1);
                end
            end
            y0 = zeros(size(x));
            for i = 1:jz + 2
                y0 = y0 + fq(:, i);
            end
            y1 = fq(:, jz + 2) - y0;
            for i = jz + 1:-1:1
                y1 = y1 + fq(:, i);
            end
            sign_ = 1 - 2 .* over_half;
            y0 = sign_ .* y0;
            y1 = sign_ .* y1;
            sign_ = 1 - 2 .* (x < 0);
            n = sign_ .* n;
            y0 = sign_ .* y0;
            y1 = sign_ .* y1;

            % nothing but zeros was left: bring in k more digits of 2/pi
            j = find(z == 0 & all(iq(:, 5:jz) == 0, 2));
            k = 5 - max((iq(j, 1:4) ~= 0) .* (1:4), [], 2);
            for more = reshape(unique(k), 1, [])
                i = j(k == more);
                [n(i), y0(i), y1(i)] = ...
                    occgrid.portable_math.reduce_huge(x(i), jz + more);
            end
        end

        % --- The words of a double ---

        function high = high_word(x)
            % upper 32 bits of each double (n, 1), as a number; a view of 64
            % bits, because the order of two halves is the machine's
            high = double(bitshift(typecast(x, 'uint64'), -32));
        end

        function low = low_word(x)
            % lower 32 bits of each double (n, 1), as a number
            low = double(bitand(typecast(x, 'uint64'), uint64(4294967295)));
        end

        function x = from_words(high, low)
            % doubles (n, 1) with these upper and lower 32 bits
            word = bitor(bitshift(uint64(high), 32), uint64(low));
            x = typecast(word, 'double');
        end

        function x = power_of_2(n)
            % 2^n for n (m, 1), exact whatever the platform's pow does
            x = occgrid.portable_math.from_words((n + 1023) .* 2^20, 0);
        end

        function bits = exponent(x)
            % exponent field of each double (n, 1)
            high = occgrid.portable_math.high_word(abs(x));
            bits = floor(high ./ 2^20);
        end

    end
end
