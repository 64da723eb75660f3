function write_file(file, text)
    % WRITE_FILE  Write a file with these bytes.
    id = fopen(file, 'w');
    assert(id >= 0, 'cannot write %s', file);
    fwrite(id, uint8(text), 'uint8');
    fclose(id);
end
