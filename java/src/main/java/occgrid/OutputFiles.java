package occgrid;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.security.SecureRandom;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.ReentrantLock;
import java.util.regex.Pattern;
import occgrid.MapWriter.WriteException;

/**
 * Files that are written into a folder together, all or none (SPEC.md
 * section 7).
 */
final class OutputFiles {
    /** Writes the content of a file. */
    interface Content {
        void writeTo(OutputStream out) throws IOException;
    }

    /** A file to be written: its name and what goes into it. */
    record Output(String name, Content content) {
    }

    private static final Duration OLD = Duration.ofHours(24);
    private static final Pattern TEMPORARY = Pattern
            .compile("\\.occgrid-[A-Za-z0-9-]{0,40}\\.part");

    /** The temporary files that exist; they change under CHANGES only. */
    private static final Set<Path> PARTS = ConcurrentHashMap.newKeySet();
    private static final ReentrantLock CHANGES = new ReentrantLock();

    private OutputFiles() {
    }

    /**
     * Writes files into a folder, which is made where it is missing.
     *
     * @throws WriteException if the folder or a file cannot be written; then
     *         none of the files is
     */
    static void write(String folder, List<Output> outputs)
            throws WriteException {
        Path place = makeFolder(folder);
        removeLeftovers(place);
        String shown = FileNames.withoutSlashes(folder);
        String before = shown.equals("/") ? shown : shown + "/";
        List<Path> targets = new ArrayList<>();
        List<Path> parts = new ArrayList<>();
        try {
            for (Output output : outputs) {
                targets.add(target(place, output, before));
            }
            for (Output output : outputs) {
                Path part = place.resolve(temporaryName());
                parts.add(part);
                writePart(part, output, before);
            }
            rename(parts, targets, outputs, before);
        } finally {
            // nothing is left of them where all went well
            parts.forEach(OutputFiles::remove);
        }
    }

    /**
     * Removes the temporary files and stops whoever wants to change a file
     * from now on, for good. For the end of the program by a signal.
     */
    static void abandon() {
        // never unlocked: the threads at work go on until the machine stops
        CHANGES.lock();
        PARTS.forEach(OutputFiles::delete);
    }

    private static Path makeFolder(String folder) throws WriteException {
        try {
            Path place = FileNames.path(folder);
            // early releases of 17 refuse a link to a folder (JDK-8294193)
            if (!Files.isDirectory(place)) {
                Files.createDirectories(place);
            }
            return place;
        } catch (IOException error) {
            throw new WriteException(FileNames.withoutSlashes(folder), error);
        }
    }

    private static Path target(Path place, Output output, String before)
            throws WriteException {
        try {
            Path target = place.resolve(FileNames.path(output.name()));
            if (Files.isDirectory(target)) {
                throw new IOException("a folder");
            }
            return target;
        } catch (IOException error) {
            throw new WriteException(before + output.name(), error);
        }
    }

    private static void writePart(Path part, Output output, String before)
            throws WriteException {
        try (OutputStream out = new BufferedOutputStream(open(part))) {
            output.content().writeTo(out);
        } catch (IOException error) {
            throw new WriteException(before + output.name(), error);
        }
    }

    private static String temporaryName() {
        byte[] random = new byte[8];
        new SecureRandom().nextBytes(random);
        return ".occgrid-" + ProcessHandle.current().pid() + "-"
                + HexFormat.of().formatHex(random) + ".part";
    }

    private static OutputStream open(Path part) throws IOException {
        CHANGES.lock();
        try {
            // not a temporary file of Java's: others may not read those
            OutputStream out = Files.newOutputStream(part,
                    StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
            PARTS.add(part);
            return out;
        } finally {
            CHANGES.unlock();
        }
    }

    /** Gives all parts their names, or none. */
    private static void rename(List<Path> parts, List<Path> targets,
            List<Output> outputs, String before) throws WriteException {
        CHANGES.lock();
        try {
            for (int i = 0; i < parts.size(); i++) {
                try {
                    Files.move(parts.get(i), targets.get(i),
                            StandardCopyOption.ATOMIC_MOVE);
                } catch (IOException error) {
                    targets.subList(0, i).forEach(OutputFiles::delete);
                    throw new WriteException(before + outputs.get(i).name(),
                            error);
                }
            }
        } finally {
            CHANGES.unlock();
        }
    }

    private static void remove(Path part) {
        CHANGES.lock();
        try {
            delete(part);
            PARTS.remove(part);
        } finally {
            CHANGES.unlock();
        }
    }

    private static void delete(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException error) {
            // the error that brought us here matters more
        }
    }

    /** Removes old temporary files, which a killed run left. */
    private static void removeLeftovers(Path place) {
        FileTime limit = FileTime.from(Instant.now().minus(OLD));
        try (DirectoryStream<Path> files = Files.newDirectoryStream(place,
                ".occgrid-*")) {
            for (Path file : files) {
                String name = file.getFileName().toString();
                if (TEMPORARY.matcher(name).matches()
                        && Files.isRegularFile(file,
                                LinkOption.NOFOLLOW_LINKS)
                        && Files.getLastModifiedTime(file)
                                .compareTo(limit) < 0) {
                    delete(file);
                }
            }
        } catch (IOException | DirectoryIteratorException error) {
            // they are in nobody's way
        }
    }
}
