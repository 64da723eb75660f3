function probe(name, input, output)
    % PROBE  Lay open what the contract is made of, for tests of all ports.
    %
    %   probe(name, input, output)
    %
    %   name: a function of probe_answers; input, output: files. Each line of
    %   the input holds the arguments of one call, separated by blanks, each
    %   line of the output its results (see CONTRIBUTING.md).
    words = regexp(read_file(input), '\S+', 'match');
    count = numel(vector_columns(name));
    assert(mod(numel(words), count) == 0, ...
        '%s takes %d arguments a line', name, count);
    lines = probe_answers(name, reshape(words, count, [])');
    write_file(output, sprintf('%s\n', lines{:}));
end
