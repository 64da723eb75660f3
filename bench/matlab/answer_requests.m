function answer_requests(map_work)
    % ANSWER_REQUESTS  Answer the benchmark's requests (see cpp/driver.hpp).
    %
    %   map_work() maps the work and returns log_odds (height, width).
    while true
        try
            % not fgetl: it waits for the line after
            line = input('', 's');
        catch
            return % no more requests
        end
        [verb, argument] = strtok(line);
        if strcmp(verb, 'map')
            for i = 1:str2double(argument)
                start = tic;
                log_odds = map_work();
                printf('%.9f ', toc(start));
            end
            printf('\n');
        else
            id = fopen(strtrim(argument), 'w');
            fprintf(id, '# logodds %d %d\n', flip(size(log_odds)));
            fprintf(id, '%.17g\n', log_odds');
            fclose(id);
            printf('written\n');
        end
        fflush(stdout);
    end
end
