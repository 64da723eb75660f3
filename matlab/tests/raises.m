function raises(action, identifier, message)
    % RAISES  Fail where an action does not raise this very error.
    try
        action();
    catch failure
        same(failure.identifier, identifier);
        same(failure.message, message);
        return
    end
    error('no error, expected %s', message);
end
