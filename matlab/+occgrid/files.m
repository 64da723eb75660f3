classdef files
    % FILES  Files and folders by any name, on MATLAB and on Octave.
    %
    %   path = occgrid.files.absolute(path)
    %   id = occgrid.files.open(path, mode)
    %   yes = occgrid.files.is_folder(path)
    %   bytes = occgrid.files.size_of(path)
    %   done = occgrid.files.read_to_end(path, id)
    %   word = occgrid.files.in_shell(path)
    %   done = occgrid.files.make_folder(path)
    %   name = occgrid.files.temporary_name()
    %   done = occgrid.files.rename(from, to)
    %   occgrid.files.remove(paths)
    %   occgrid.files.remove_old(folder)
    %   text = occgrid.files.shown(path)
    %
    %   Octave's dir, delete and exist read *, ?, [ and \ in a name as a
    %   pattern, and its fopen looks in other folders too. Its stat, unlink and
    %   rename take a name as it is, so they serve here where they exist. No
    %   function here raises an error: each one's value tells.

    methods (Static)

        function path = absolute(path)
            % ABSOLUTE  A path from the root.
            rooted = strncmp(path, '/', 1) || strncmp(path, filesep, 1) || ...
                (ispc && numel(path) > 1 && path(2) == ':');
            if ~rooted
                path = [pwd, '/', path];
            end
        end

        function id = open(path, mode)
            % OPEN  fopen, or -1 also for what names a folder.
            id = -1;
            if ~isempty(path) && path(end) ~= '/' && ...
                    occgrid.files.sayable(path) && ...
                    ~occgrid.files.is_folder(path)
                id = fopen(occgrid.files.absolute(path), mode);
            end
        end

        function yes = is_folder(path)
            % IS_FOLDER  Whether a path is that of a folder.
            yes = isfolder(occgrid.files.absolute(path));
        end

        function bytes = size_of(path)
            % SIZE_OF  A file's size in bytes; -1 where there is none.
            bytes = -1;
            path = occgrid.files.absolute(path);
            if exist('OCTAVE_VERSION', 'builtin')
                found = stat(path);
                if ~isempty(found)
                    bytes = found.size;
                end
            else
                found = dir(path);
                if isscalar(found)
                    bytes = found.bytes;
                end
            end
        end

        function done = read_to_end(path, id)
            % READ_TO_END  Whether an open file was read as far as it goes.
            %
            %   A failed read looks like the end of the file.
            done = max(ftell(id), 0) >= occgrid.files.size_of(path);
            if done && exist('OCTAVE_VERSION', 'builtin') && ftell(id) == 0
                % nothing came, and the size does not show whether there is
                % anything: /proc has such files
                found = stat(occgrid.files.absolute(path));
                done = isempty(found) || found.modestr(1) ~= '-' || ...
                    system(['cat ', occgrid.files.in_shell(path), ...
                            ' > /dev/null 2> /dev/null']) == 0;
            end
        end

        function word = in_shell(path)
            % IN_SHELL  A path from the root as one word of a shell command.
            path = occgrid.files.absolute(path);
            word = ['''', strrep(path, '''', '''\'''''), ''''];
        end

        function done = make_folder(path)
            % MAKE_FOLDER  Make a folder with its parents, if it is not there.
            done = occgrid.files.sayable(path);
            if done && ~occgrid.files.is_folder(path)
                done = mkdir(occgrid.files.absolute(path));
            end
        end

        function name = temporary_name()
            % TEMPORARY_NAME  A new name for a file that is not yet whole.
            %
            %   SPEC.md section 7: .occgrid-, up to 40 characters, .part.
            [~, unique_] = fileparts(tempname());
            unique_ = unique_(isstrprop(unique_, 'alphanum'));
            if exist('OCTAVE_VERSION', 'builtin')
                unique_ = sprintf('%d-%s', getpid(), unique_);
            end
            name = ['.occgrid-', unique_(1:min(end, 40)), '.part'];
        end

        function done = rename(from, to)
            % RENAME  Give a file another name in its folder, in one step.
            from = occgrid.files.absolute(from);
            to = occgrid.files.absolute(to);
            done = ~occgrid.files.is_folder(to); % movefile would go into it
            if done && exist('OCTAVE_VERSION', 'builtin')
                done = rename(from, to) == 0;
            elseif done
                done = movefile(from, to, 'f');
            end
        end

        function remove(paths)
            % REMOVE  Delete those files, a cell array, that are there.
            for i = 1:numel(paths)
                path = occgrid.files.absolute(paths{i});
                if exist('OCTAVE_VERSION', 'builtin')
                    [~, ~] = unlink(path);
                elseif isfile(path)
                    delete(path);
                end
            end
        end

        function remove_old(folder)
            % REMOVE_OLD  Delete temporary files that a killed run left.
            %
            %   Those of temporary_name's form, more than 24 hours old.
            on_octave = exist('OCTAVE_VERSION', 'builtin');
            folder = occgrid.files.absolute(folder);
            if on_octave
                [names, failed] = readdir(folder);
                if failed
                    return
                end
            else
                listed = dir(folder);
                names = {listed.name};
            end
            for i = 1:numel(names)
                if ~occgrid.files.is_temporary(names{i})
                    continue
                end
                path = [folder, '/', names{i}];
                if on_octave
                    found = lstat(path);
                    old = ~isempty(found) && found.modestr(1) == '-' && ...
                        time() - found.mtime > 24 * 60 * 60;
                else
                    old = ~listed(i).isdir && ...
                        now() - listed(i).datenum > 1; %#ok<TNOW1>
                end
                if old
                    occgrid.files.remove({path});
                end
            end
        end

        function text = shown(path)
            % SHOWN  A path as messages show it, on one line.
            text = path;
            text(text < 32 | text == 127) = '?';
        end

    end

    methods (Static, Access = private)

        function yes = sayable(path)
            % whether Octave takes the path as it is: its functions put a
            % home folder in place of ~ after a blank or a colon, too
            yes = true;
            if exist('OCTAVE_VERSION', 'builtin')
                path = occgrid.files.absolute(path);
                yes = strcmp(tilde_expand(path), path);
            end
        end

        function yes = is_temporary(name)
            % whether a name is of temporary_name's form
            middle = name(10:end - 5);
            yes = strncmp(name, '.occgrid-', 9) && ...
                strcmp(name(max(end - 4, 1):end), '.part') && ...
                any(numel(middle) == 1:40) && ...
                all(middle == '-' | (middle >= '0' & middle <= '9') | ...
                    (middle >= 'A' & middle <= 'Z') | ...
                    (middle >= 'a' & middle <= 'z'));
        end

    end
end
