function restores = seeded(seed)
    % SEEDED  Seed the random generator until restores is cleared.
    %
    %   Then the caller's generator is as it was.
    before = rng();
    restores = onCleanup(@() rng(before));
    rng(seed, 'twister');
end
