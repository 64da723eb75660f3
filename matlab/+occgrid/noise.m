classdef noise
    % NOISE  Range noise that depends on the seed, the scan and the beam only.
    %
    %   w = occgrid.noise.philox4x32(counter, key)
    %   n = occgrid.noise.normal_deviate(seed, scan, beam)
    %   ranges = occgrid.noise.add_range_noise(ranges, noise_std, seed, ...
    %                                          scan, z_max)
    %
    %   SPEC.md section 3.3. The built-in rng and randn are other generators.

    methods (Static)

        % [snippet: philox]
        function words = philox4x32(counter, key)
            % PHILOX4X32  Philox4x32-10: four random words per counter.
            %
            %   counter: (4, n) words below 2^32, a column each; key: (2, 1)
            %   or (2, n) words. words: (4, n) doubles below 2^32.
            %
            %   Source: Salmon et al. (2011), Parallel random numbers.

            % a product of two words needs the 64 bits of a uint64, which
            % MATLAB's integer types would cut off (saturate) above that
            m0 = uint64(hex2dec('D2511F53'));
            m1 = uint64(hex2dec('CD9E8D57'));
            low_word = uint64(hex2dec('FFFFFFFF'));
            c = uint64(counter);
            c0 = c(1, :);
            c1 = c(2, :);
            c2 = c(3, :);
            c3 = c(4, :);
            k0 = key(1, :) + zeros(size(c0));
            k1 = key(2, :) + zeros(size(c0));
            for i = 1:10
                product0 = c0 .* m0;
                product1 = c2 .* m1;
                c0 = bitxor(bitxor(bitshift(product1, -32), c1), uint64(k0));
                c1 = bitand(product1, low_word);
                c2 = bitxor(bitxor(bitshift(product0, -32), c3), uint64(k1));
                c3 = bitand(product0, low_word);
                k0 = mod(k0 + 2654435769, 2^32); % 9E3779B9
                k1 = mod(k1 + 3144134277, 2^32); % BB67AE85
            end
            words = double([c0; c1; c2; c3]);
        end

        % [/snippet]

        % [snippet: normal-deviate]
        function n = normal_deviate(seed, scan, beam)
            % NORMAL_DEVIATE  Standard normal deviates, one per beam.
            %
            %   seed: 0 to 2^32 - 1; scan, beam: numbers from 0, of one shape
            %   (or one of them a scalar). n: of that shape.
            %
            %   Source: Box and Muller (1958).
            scan = scan + zeros(size(beam));
            beam = beam + zeros(size(scan));
            zero = zeros(1, numel(beam));
            counter = [mod(reshape(scan, 1, []), 2^32)
                       reshape(beam, 1, []); zero; zero];
            words = occgrid.noise.philox4x32(counter, [seed; 0]);
            u1 = (words(1, :) + 0.5) ./ 4294967296;
            u2 = (words(2, :) + 0.5) ./ 4294967296;
            radius = sqrt(-2 .* occgrid.portable_math.log(u1));
            n = radius .* occgrid.portable_math.cos((2.0 .* pi) .* u2);
            n = reshape(n, size(beam));
        end

        % [/snippet]

        % [snippet: range-noise]
        function ranges = add_range_noise(ranges, noise_std, seed, scan, z_max)
            % ADD_RANGE_NOISE  Simulated ranges with noise, in [0, z_max].
            %
            %   ranges: (n, 1) metres, or (n, m) for m scans side by side;
            %   scan: their numbers from 0, (1, m). A beam that met no wall
            %   gets noise too, as in the lesson.
            beam = (0:size(ranges, 1) - 1)';
            scan = repmat(scan, size(ranges, 1), 1);
            beam = repmat(beam, 1, size(ranges, 2));
            deviates = occgrid.noise.normal_deviate(seed, scan, beam);
            noisy = ranges + noise_std .* deviates;
            ranges = min(max(noisy, 0), z_max);
        end

        % [/snippet]

    end
end
