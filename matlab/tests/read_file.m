function text = read_file(file)
    % READ_FILE  The bytes of a file, as text.
    id = fopen(file, 'r');
    assert(id >= 0, 'cannot read %s', file);
    text = fread(id, [1, Inf], 'uint8=>char');
    fclose(id);
end
