function skip(reason)
    % SKIP  End a test that cannot run here; run_tests says so and counts it.
    error('occgrid:skip', '%s', reason);
end
