function same(actual, expected)
    % SAME  Fail where two values differ in class, shape or any bit.
    %
    %   Two NaN are the same; 0 and -0 are not.
    assert(strcmp(class(actual), class(expected)), ...
        'a %s, expected a %s', class(actual), class(expected));
    assert(isequal(size(actual), size(expected)), ...
        'shape %s, expected %s', mat2str(size(actual)), ...
        mat2str(size(expected)));
    if isfloat(actual)
        differ = ~(actual == expected | (isnan(actual) & isnan(expected)));
        differ = differ | (actual == 0 & 1 ./ actual ~= 1 ./ expected);
        i = find(differ, 1);
        assert(isempty(i), 'element %d is %.17g, expected %.17g', ...
            i, actual(i), expected(i));
    elseif ischar(actual)
        assert(isequal(actual, expected), ...
            '''%s'', expected ''%s''', actual, expected);
    else
        assert(isequal(actual, expected), 'not the expected value');
    end
end
