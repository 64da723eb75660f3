function [folder, removes] = temporary_folder()
    % TEMPORARY_FOLDER  A new folder, removed when removes is cleared.
    folder = tempname();
    mkdir(folder);
    removes = onCleanup(@() remove(folder));
end

function remove(folder)
    if exist('OCTAVE_VERSION', 'builtin')
        before = confirm_recursive_rmdir(false);
        restores = onCleanup(@() confirm_recursive_rmdir(before));
    end
    rmdir(folder, 's');
end
