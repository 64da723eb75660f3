function columns = vector_columns(name)
    % VECTOR_COLUMNS  The arguments of a function of probe_answers.
    switch name
        case {'sin', 'cos', 'exp', 'log'}
            columns = {'x'};
        case 'logit'
            columns = {'p'};
        case {'sigmoid', 'pixel'}
            columns = {'log_odds'};
        case 'world_to_grid'
            columns = {'resolution', 'origin_x', 'origin_y', 'x', 'y'};
        case 'bresenham'
            columns = {'gx0', 'gy0', 'gx1', 'gy1'};
        case 'clip_ray'
            columns = {'gx0', 'gy0', 'gx1', 'gy1', 'width', 'height'};
        case 'flaser_angles'
            columns = {'n_beams', 'beam'};
        case 'read_ranges'
            columns = {'range', 'z_max', 'no_return'};
        case 'beam_endpoints'
            columns = {'x', 'y', 'theta', 'angle', 'z'};
        case 'update_cell'
            columns = {'p0', 'p_occ', 'p_free', 'l_min', 'l_max', 'updates'};
        case 'philox'
            columns = {'c0', 'c1', 'c2', 'c3', 'k0', 'k1'};
        case 'normal_deviate'
            columns = {'seed', 'scan', 'beam'};
        otherwise
            error('no function %s', name);
    end
end
