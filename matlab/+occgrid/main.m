function status = main(varargin)
    % MAIN  The command line (SPEC.md section 6).
    %
    %   status = occgrid.main('--seed', '1', '--out', 'maps', 'office.log')
    %
    %   Takes the command's arguments and returns its exit status: 0, 1 where
    %   a scenario or an output failed, 2 for bad usage.
    [options, wrong] = read_options(cellfun(@char, varargin, ...
                                            'UniformOutput', false));
    if ~isempty(wrong)
        fprintf(2, 'occgrid: %s\n%s', occgrid.files.shown(wrong), usage());
        status = 2;
        return
    end
    status = 0;
    try
        run(options);
    catch failure
        if ~any(strcmp(failure.identifier, ...
                       {'occgrid:scenario', 'occgrid:output'}))
            rethrow(failure);
        end
        fprintf(2, '%s\n', failure.message);
        status = 1;
    end
end

function run(options)
    % what the options ask for
    if strcmp(options.show, 'help')
        occgrid.map_writer.print_out(@(put) put(usage()));
        return
    elseif strcmp(options.show, 'version')
        text = sprintf('occgrid 1.0.0 (%s)\n', language());
        occgrid.map_writer.print_out(@(put) put(text));
        return
    end
    if isempty(options.scenarios)
        map_one(occgrid.lesson.lesson_scenario(), options);
    end
    for i = 1:numel(options.scenarios)
        map_one(occgrid.scenario.read_scenario(options.scenarios{i}), options);
    end
end

function map_one(s, options)
    % map one scenario and write what was asked for
    if options.plain
        grid = occgrid.mapper.map_scenario(s, options.seed);
    else
        started = tic;
        grid = occgrid.fast.map_scenario_fast(s, options.seed, @(done) ...
            show_progress(s.name, done, numel(s.scans), toc(started)));
    end
    if ~ischar(options.out)
        occgrid.map_writer.print_out( ...
            @(put) occgrid.map_writer.map_pgm(grid, put));
    else
        occgrid.map_writer.write_map(options.out, s.name, grid);
    end
    if ischar(options.plot)
        occgrid.picture.draw_map(grid, options.plot);
    end
end

function show_progress(name, done, scans, seconds)
    % on standard error, how long a long log still takes: on a terminal
    % after two seconds, on one line that is cleared at the end; elsewhere a
    % line after ten seconds, and then each minute
    persistent next terminal
    if seconds < 2
        next = [];
        return
    elseif isempty(next)
        % only Octave's system has this process's own standard error
        terminal = exist('OCTAVE_VERSION', 'builtin') && ~ispc && ...
            system('test -t 2') == 0;
        next = 2 + 8 * ~terminal;
    end
    if terminal && done == scans
        fprintf(2, '\r\033[K');
    elseif done < scans && seconds >= next
        text = sprintf('%s: %.0f %% mapped, about %.0f s to go', ...
                       occgrid.files.shown(name), 100 * done / scans, ...
                       seconds * (scans - done) / done);
        if terminal
            fprintf(2, '\r\033[K%s', text);
        else
            fprintf(2, '%s\n', text);
        end
        next = seconds + 1 + 59 * ~terminal;
    end
end

function [options, wrong] = read_options(args)
    % the options, from left to right, and what is wrong with them; stops at
    % --help and --version
    options = struct('seed', 0, 'plain', false, 'out', [], 'plot', [], ...
                     'show', '');
    options.scenarios = {};
    wrong = '';
    noise_free = false;
    seeded = false;
    i = 1;
    while i <= numel(args)
        argument = args{i};
        if any(strcmp(argument, {'--seed', '--out', '--plot'}))
            i = i + 1;
            if i > numel(args) || isempty(args{i}) || strncmp(args{i}, '--', 2)
                wrong = ['argument ', argument, ': a value is missing'];
                return
            end
        end
        switch argument
            case {'--help', '--version'}
                options.show = argument(3:end);
                return
            case '--noise-free'
                noise_free = true;
            case '--plain'
                options.plain = true;
            case '--seed'
                seeded = true;
                [options.seed, wrong] = read_seed(args{i});
            case '--out'
                options.out = args{i};
            case '--plot'
                options.plot = args{i};
            otherwise
                if strncmp(argument, '-', 1)
                    wrong = ['there is no option ', argument];
                else
                    options.scenarios{end + 1} = argument;
                end
        end
        if ~isempty(wrong)
            return
        end
        i = i + 1;
    end

    names = cellfun(@occgrid.scenario.scenario_name, options.scenarios, ...
                    'UniformOutput', false);
    [~, first] = unique(names, 'first');
    if noise_free && seeded
        wrong = '--noise-free and --seed exclude each other';
    elseif numel(names) > 1 && ~ischar(options.out)
        wrong = 'several scenarios need --out';
    elseif numel(names) > 1 && ischar(options.plot)
        wrong = '--plot draws one scenario';
    elseif numel(first) < numel(names)
        twice = setdiff(1:numel(names), first);
        wrong = ['two scenarios are named ', names{twice(1)}];
    end
    if noise_free
        options.seed = [];
    end
end

function [seed, wrong] = read_seed(text)
    % a whole number from 0 to 2^32 - 1
    seed = 0;
    wrong = '';
    digits = all(text >= '0' & text <= '9');
    if digits
        seed = sscanf(text, '%f');
    end
    if ~digits || seed > 4294967295
        wrong = ['argument --seed: a whole number from 0 to 4294967295 ' ...
                 'is needed, not ''', text, ''''];
    end
end

function text = usage()
    lines = { ...
        ['usage: occgrid [--noise-free | --seed N] [--plain] [--out DIR] ' ...
         '[SCENARIO...]']
        ''
        'Map range scans into an occupancy grid.'
        ''
        '  SCENARIO      scenario files (CARMEN logs); without: the lesson'
        '  --noise-free  simulate ranges without noise'
        '  --seed N      seed of the noise (default: 0)'
        '  --plain       map beam by beam, with the program as it is printed'
        '  --out DIR     write NAME.pgm, NAME.yaml, NAME.logodds there;'
        '                without: the PGM on standard output'
        '  --plot FILE   draw the map with axes and colour bar'
        '  --version     print the version'
        '  --help        print this'};
    text = sprintf('%s\n', lines{:});
end

function text = language()
    text = 'MATLAB';
    if exist('OCTAVE_VERSION', 'builtin')
        text = 'GNU Octave';
    end
    text = [text, ' ', version()];
end
