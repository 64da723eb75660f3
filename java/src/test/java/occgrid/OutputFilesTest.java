package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import occgrid.MapWriter.WriteException;
import occgrid.OutputFiles.Content;
import occgrid.OutputFiles.Output;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class OutputFilesTest {
    @TempDir
    private Path folder;

    private static Content text(String text) {
        return out -> out.write(text.getBytes("UTF-8"));
    }

    private static void write(String folder, String name)
            throws WriteException {
        OutputFiles.write(folder, List.of(new Output(name + ".1", text("x")),
                new Output(name + ".2", text("y")),
                new Output(name + ".3", text("z"))));
    }

    private String writeFails(String folder, String name) {
        return assertThrows(WriteException.class, () -> write(folder, name))
                .getMessage();
    }

    private static List<String> names(Path where) throws IOException {
        try (Stream<Path> files = Files.list(where)) {
            return files.map(file -> file.getFileName().toString()).sorted()
                    .toList();
        }
    }

    @Test
    void filesAreWrittenAndReplaced() throws IOException {
        Path out = folder.resolve("a/b");
        write(out.toString(), "m");
        Files.writeString(out.resolve("m.2"), "old");
        write(out + "//", "m");
        assertEquals(List.of("m.1", "m.2", "m.3"), names(out));
        assertEquals("y", Files.readString(out.resolve("m.2")));
    }

    @Test
    void aLinkToAFolderIsAFolder() throws IOException {
        Path real = Files.createDirectory(folder.resolve("real"));
        Path link = Files.createSymbolicLink(folder.resolve("link"), real);
        write(link.toString(), "m");
        assertEquals(3, names(real).size());
    }

    /** Whichever of the targets it is: all or nothing. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void aFolderInTheWay(int number) throws IOException {
        String taken = Files.createDirectory(folder.resolve("m." + number))
                .toString();
        assertEquals(taken + ": cannot be written",
                writeFails(folder.toString(), "m"));
        assertEquals(List.of("m." + number), names(folder));
    }

    /** What was renamed before a renaming that fails goes away. */
    @Test
    void aRenamingThatFails() throws IOException {
        Path taken = folder.resolve("m.2");
        Content trouble = out -> Files.createDirectory(taken);
        WriteException error = assertThrows(WriteException.class,
                () -> OutputFiles.write(folder.toString(),
                        List.of(new Output("m.1", text("x")),
                                new Output("m.2", trouble),
                                new Output("m.3", text("z")))));
        assertEquals(taken + ": cannot be written", error.getMessage());
        assertEquals(List.of("m.2"), names(folder));
    }

    @Test
    void aFullDisk() throws IOException {
        Content full = out -> {
            throw new IOException("full");
        };
        WriteException error = assertThrows(WriteException.class,
                () -> OutputFiles.write(folder.toString(),
                        List.of(new Output("m.1", text("x")),
                                new Output("m.2", full))));
        assertEquals(folder.resolve("m.2") + ": cannot be written",
                error.getMessage());
        assertEquals(List.of(), names(folder));
    }

    @Test
    void theFolderIsNamedWhereItCannotBeMade() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "");
        for (String out : List.of(file.toString(), file + "/a/b",
                folder + "/a\0b")) {
            assertEquals(out + ": cannot be written", writeFails(out, "m"));
            assertEquals(out + ": cannot be written",
                    writeFails(out + "//", "m"));
        }
    }

    /** As it was given, but for slashes at the end. */
    @ParameterizedTest
    @CsvSource({"/./o//q/, /./o//q/m.1", "//q, //q/m.1"})
    void pathsAreSpelledAsGiven(String given, String shown)
            throws IOException {
        Files.createDirectories(folder.resolve("o/q/m.1"));
        Files.createDirectories(folder.resolve("q/m.1"));
        assertEquals(folder + shown + ": cannot be written",
                writeFails(folder + given, "m"));
    }

    @ParameterizedTest
    @CsvSource({"/, /", "//, /", "a/, a", "./a//b//, ./a//b", "a, a"})
    void slashesAtTheEnd(String given, String shown) {
        assertEquals(shown, FileNames.withoutSlashes(given));
    }

    /** Temporary names are short, whatever the name is. */
    @Test
    void longNames() throws IOException {
        String longest = "n".repeat(253);
        write(folder.toString(), longest);
        assertEquals(3, names(folder).size());
        assertEquals(folder + "/" + longest + "n.1: cannot be written",
                writeFails(folder.toString(), longest + "n"));
        assertEquals(3, names(folder).size());
    }

    @Test
    void othersMayReadTheFiles() throws IOException {
        write(folder.toString(), "m");
        Path like = Files.createFile(folder.resolve("like"));
        assertEquals(Files.getPosixFilePermissions(like),
                Files.getPosixFilePermissions(folder.resolve("m.1")));
    }

    @Test
    void oldLeftoversAreRemoved() throws IOException {
        FileTime old = FileTime
                .from(Instant.now().minus(Duration.ofHours(25)));
        FileTime young = FileTime
                .from(Instant.now().minus(Duration.ofHours(23)));
        String[] leave = {".occgrid-a_b.part", ".occgrid-1.part.txt",
                ".occgrid-" + "a".repeat(41) + ".part", "occgrid-1.part"};
        for (String name : leave) {
            Files.setLastModifiedTime(
                    Files.createFile(folder.resolve(name)), old);
        }
        Path fresh = Files.createFile(folder.resolve(".occgrid-9.part"));
        Files.setLastModifiedTime(fresh, young);
        Path link = Files.createSymbolicLink(
                folder.resolve(".occgrid-7.part"), folder.resolve(leave[0]));
        for (String name : new String[]{".occgrid-.part",
                ".occgrid-12-Ab.part",
                ".occgrid-" + "a".repeat(40) + ".part"}) {
            Files.setLastModifiedTime(
                    Files.createFile(folder.resolve(name)), old);
        }
        write(folder.toString(), "m");
        List<String> names = names(folder);
        assertTrue(names.containsAll(List.of(leave)));
        assertTrue(Files.exists(fresh));
        assertTrue(Files.isSymbolicLink(link));
        assertEquals(leave.length + 5, names.size(), names.toString());
    }
}
