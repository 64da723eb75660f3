function tests = test_noise()
    % TEST_NOISE  Philox's known answers; noise per beam; its limits.
    tests = {@philox_known_answers, @deviates, @order_does_not_matter, ...
             @looks_normal, @noise_stays_in_range, @no_noise};
end

function philox_known_answers()
    counters = {'00000000', '00000000', '00000000', '00000000'
                'ffffffff', 'ffffffff', 'ffffffff', 'ffffffff'
                '243f6a88', '85a308d3', '13198a2e', '03707344'};
    keys = {'00000000', '00000000'
            'ffffffff', 'ffffffff'
            'a4093822', '299f31d0'};
    answers = {'6627e8d5', 'e169c58d', 'bc57ac4c', '9b00dbd8'
               '408f276d', '41c83b0e', 'a20bc7c6', '6d5451fd'
               'd16cfe09', '94fdcceb', '5001e420', '24126ea1'};
    counter = words(counters);
    key = words(keys);
    answer = words(answers);
    same(occgrid.noise.philox4x32(counter, key), answer);
    for i = 1:3
        same(occgrid.noise.philox4x32(counter(:, i), key(:, i)), ...
            answer(:, i));
    end
end

function w = words(rows)
    w = reshape(hex2dec(rows'), size(rows, 2), []);
end

function deviates()
    same(occgrid.noise.normal_deviate(0, 0, [0, 1, 180]), ...
        hex2num({'3fefb7665e244c5e'; '3ff22e8f71900bf3'
                 '40006a9887fc6292'})');
    same(occgrid.noise.normal_deviate(1, 7, 3), hex2num('3fe4db87118a6e82'));
    same(occgrid.noise.normal_deviate(4294967295, 119, 180), ...
        hex2num('bfe9baec5205ce8d'));
end

function order_does_not_matter()
    beams = [5; 0; 17; 5];
    n = occgrid.noise.normal_deviate(3, 2, beams);
    for i = 1:4
        same(n(i), occgrid.noise.normal_deviate(3, 2, beams(i)));
    end
    ranges = repmat(5, 20, 3);
    together = occgrid.noise.add_range_noise(ranges, 0.1, 3, [1, 2, 9], 10);
    scan = occgrid.noise.add_range_noise(ranges(:, 1), 0.1, 3, 2, 10);
    same(together(:, 2), scan);
    same(together(6, 2), 5 + 0.1 * n(1));
end

function looks_normal()
    n = occgrid.noise.normal_deviate(1, 0, (0:99999)');
    assert(abs(mean(n)) < 0.015);
    assert(abs(std(n) - 1) < 0.015);
    assert(abs(mean(abs(n) < 1.96) - 0.95) < 0.005);
end

function noise_stays_in_range()
    ranges = [zeros(500, 1); repmat(10, 500, 1)];
    noisy = occgrid.noise.add_range_noise(ranges, 1, 0, 0, 10);
    assert(all(noisy >= 0 & noisy <= 10));
    assert(any(noisy(1:500) == 0) && any(noisy(1:500) > 0));
    assert(any(noisy(501:end) == 10) && any(noisy(501:end) < 10));
end

function no_noise()
    ranges = [0; 2.5; 10];
    same(occgrid.noise.add_range_noise(ranges, 0, 7, 3, 10), ranges);
end
