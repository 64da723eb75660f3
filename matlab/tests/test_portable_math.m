function tests = test_portable_math()
    % TEST_PORTABLE_MATH  The bits that Java's StrictMath gives.
    tests = {@known_bits, @sums_of_bits, @any_shape, @nothing};
end

function known_bits()
    table = { ...
            'sin', '0000000000000000', '0000000000000000'
            'sin', '8000000000000000', '8000000000000000'
            'sin', '0000000000000001', '0000000000000001'
            'sin', '3e112e0be826d695', '3e112e0be826d695'
            'sin', '3fe0000000000000', '3fdeaee8744b05f0'
            'sin', 'bfe0000000000000', 'bfdeaee8744b05f0'
            'sin', '3fe921fb54442d18', '3fe6a09e667f3bcc'
            'sin', '3ff0000000000000', '3feaed548f090cee'
            'sin', '3ff921fb54442d18', '3ff0000000000000'
            'sin', '4000000000000000', '3fed18f6ead1b446'
            'sin', '400921fb54442d18', '3ca1a62633145c07'
            'sin', 'c002d97c7f3321d2', 'bfe6a09e667f3bcd'
            'sin', '4024000000000000', 'bfe1689ef5f34f52'
            'sin', '4051475cc9eedf00', 'bd06111d218effa2'
            'sin', '4059000000000000', 'bfe03425b78c4db8'
            'sin', 'c076300000000000', '3eff9bd0307d1de3'
            'sin', '40f86a0000000000', '3fa24daa9c527e96'
            'sin', '412921fb33333333', 'bfb0858be515492b'
            'sin', '4480f0cf064dd592', 'bfeb453ab76bf397'
            'sin', 'fe37e43c8800759c', '3fea2c16b010e385'
            'sin', '7506ac5b262ca1ff', '3ff0000000000000'
            'sin', '7fefffffffffffff', '3f7452fc98b34e97'
            'sin', '7ff0000000000000', '7ff8000000000000'
            'sin', 'fff0000000000000', '7ff8000000000000'
            'sin', '7ff8000000000000', '7ff8000000000000'
            'cos', '0000000000000000', '3ff0000000000000'
            'cos', '8000000000000000', '3ff0000000000000'
            'cos', '0000000000000001', '3ff0000000000000'
            'cos', '3e112e0be826d695', '3ff0000000000000'
            'cos', '3fe0000000000000', '3fec1528065b7d50'
            'cos', 'bfe0000000000000', '3fec1528065b7d50'
            'cos', '3fe921fb54442d18', '3fe6a09e667f3bcd'
            'cos', '3ff0000000000000', '3fe14a280fb5068c'
            'cos', '3ff921fb54442d18', '3c91a62633145c07'
            'cos', '4000000000000000', 'bfdaa22657537205'
            'cos', '400921fb54442d18', 'bff0000000000000'
            'cos', 'c002d97c7f3321d2', 'bfe6a09e667f3bcc'
            'cos', '4024000000000000', 'bfead9ac890c6b1f'
            'cos', '4051475cc9eedf00', '3ff0000000000000'
            'cos', '4059000000000000', '3feb981dbf665fdf'
            'cos', 'c076300000000000', 'bfefffffffc18e4c'
            'cos', '40f86a0000000000', 'bfeffac3841b3da7'
            'cos', '412921fb33333333', '3fefeeebfee47670'
            'cos', '4480f0cf064dd592', '3fe0be2cef01c8f4'
            'cos', 'fe37e43c8800759c', 'bfe2699022adc4c1'
            'cos', '7506ac5b262ca1ff', 'bc214ae72e6ba22f'
            'cos', '7fefffffffffffff', 'bfefffe62ecfab75'
            'cos', '7ff0000000000000', '7ff8000000000000'
            'cos', 'fff0000000000000', '7ff8000000000000'
            'cos', '7ff8000000000000', '7ff8000000000000'
            'exp', '0000000000000000', '3ff0000000000000'
            'exp', '8000000000000000', '3ff0000000000000'
            'exp', '0000000000000001', '3ff0000000000000'
            'exp', '3e112e0be826d695', '3ff000000044b830'
            'exp', '3fd3333333333333', '3ff599058c8c1a96'
            'exp', 'bfd3333333333333', '3fe7b4c869c37c05'
            'exp', '3fe0000000000000', '3ffa61298e1e069c'
            'exp', '3ff0000000000000', '4005bf0a8b14576a'
            'exp', 'bff0000000000000', '3fd78b56362cef38'
            'exp', '4004000000000000', '40285d6fd931e0bb'
            'exp', 'c024000000000000', '3f07cd79b5647c9a'
            'exp', '4059000000000000', '48f3494a9b171bf5'
            'exp', '40862e42fefa39ef', '7fefffffffffff2a'
            'exp', '40862e42fefa39f0', '7ff0000000000000'
            'exp', 'c086233333333333', '000ff15b469edf89'
            'exp', 'c0874910d52d3051', '0000000000000001'
            'exp', 'c0874910d52d3052', '0000000000000000'
            'exp', '7fefffffffffffff', '7ff0000000000000'
            'exp', 'ffefffffffffffff', '0000000000000000'
            'exp', '7ff0000000000000', '7ff0000000000000'
            'exp', 'fff0000000000000', '0000000000000000'
            'exp', '7ff8000000000000', '7ff8000000000000'
            'log', '0000000000000000', 'fff0000000000000'
            'log', '8000000000000000', 'fff0000000000000'
            'log', '0000000000000001', 'c0874385446d71c3'
            'log', '0010000000000000', 'c086232bdd7abcd2'
            'log', '3e112e0be826d695', 'c034b927f32bffb8'
            'log', '3fd3333333333333', 'bff34378fcbda721'
            'log', '3fe0000000000000', 'bfe62e42fefa39ef'
            'log', '3ff0000000000000', '0000000000000000'
            'log', '3ff0000000000001', '3cafffffffffffff'
            'log', '3fefffffffffffff', 'bca0000000000000'
            'log', '3ff000008637bd06', '3ea0c6f75a619b84'
            'log', '3ff3333333333333', '3fc7565011e49675'
            'log', '3ff6a09e667f3bcd', '3fd62e42fefa39f0'
            'log', '4000000000000000', '3fe62e42fefa39ef'
            'log', '4008000000000000', '3ff193ea7aad030a'
            'log', '4008000000000001', '3ff193ea7aad030b'
            'log', '4024000000000000', '40026bb1bbb55516'
            'log', '4480f0cf064dd592', '40495414621954fe'
            'log', '7fefffffffffffff', '40862e42fefa39ef'
            'log', 'bff0000000000000', '7ff8000000000000'
            'log', '7ff0000000000000', '7ff0000000000000'
            'log', 'fff0000000000000', '7ff8000000000000'
            'log', '7ff8000000000000', '7ff8000000000000'
            };
    for i = 1:size(table, 1)
        x = hex2num(table{i, 2});
        actual = lower(num2hex(call(table{i, 1}, x)));
        if isnan(call(table{i, 1}, x))
            actual = '7ff8000000000000';
        end
        assert(strcmp(actual, table{i, 3}), '%s(%s) is %s, expected %s', ...
            table{i, 1}, table{i, 2}, actual, table{i, 3});
    end
    % all at once, so that no element disturbs another
    for name = {'sin', 'cos', 'exp', 'log'}
        rows = strcmp(table(:, 1), name{1});
        same(call(name{1}, hex2num(table(rows, 2))), ...
            hex2num(table(rows, 3)));
    end
end

function sums_of_bits()
    % 20,000 results each, of arguments i * step - start (for log without
    % sign): the sums of their upper and of their lower 32 bits
    table = { ...
        'sin', 0.0012345678901234, 12.0, 43291343325098, 42949459082860
        'sin', 123.45678901234, 0.0, 42919588262625, 42765250276565
        'sin', 1.2345678901234e300, 0.0, 42904636307584, 43006192779252
        'sin', 0.037, 370.0, 42905684181426, 42847528252444
        'sin', 0.000012345678901234, 0.0, 21379970562836, 42854023473475
        'cos', 0.0012345678901234, 12.0, 43292903452148, 42558237324714
        'cos', 123.45678901234, 0.0, 42895964140927, 42808912869234
        'cos', 1.2345678901234e300, 0.0, 42953915275606, 43088539354355
        'cos', 0.037, 370.0, 42945318954940, 43078412695168
        'cos', 0.000012345678901234, 0.0, 21453440030076, 42750528489567
        'exp', 0.0012345678901234, 12.0, 21463145979554, 43073500977697
        'exp', 0.037, 370.0, 21453222688144, 42708657337789
        'exp', 0.000012345678901234, 0.0, 21456681097268, 42751655460984
        'log', 0.0012345678901234, 12.0, 24942073544030, 42472237143836
        'log', 123.45678901234, 0.0, 21531770452145, 42950980081810
        'log', 1.2345678901234e300, 0.0, 21650304605603, 43061783046276
        'log', 0.037, 370.0, 21618782309519, 43198964576066
        'log', 0.000012345678901234, 0.0, 64426729630974, 43109562789150
            };
    for row = table'
        [name, step, start, upper, lower] = row{:};
        x = (1:20000)' .* step - start;
        if strcmp(name, 'log')
            x = abs(x);
        end
        bits = typecast(call(name, x), 'uint64');
        sums = [sum(double(bitshift(bits, -32))), ...
                sum(double(bitand(bits, uint64(4294967295))))];
        assert(isequal(sums, [upper, lower]), '%s with step %g', name, step);
    end
end

function any_shape()
    x = reshape(-5:0.25:6.75, 2, 4, 6);
    for name = {'sin', 'cos', 'exp', 'log'}
        y = call(name{1}, x);
        same(size(y), [2, 4, 6]);
        same(y(:, 3, 2), call(name{1}, x(:, 3, 2)));
        same(y(2, 1, 6), call(name{1}, x(2, 1, 6)));
    end
end

function nothing()
    for name = {'sin', 'cos', 'exp', 'log'}
        same(call(name{1}, zeros(1, 0)), zeros(1, 0));
    end
end

function y = call(name, x)
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
end
