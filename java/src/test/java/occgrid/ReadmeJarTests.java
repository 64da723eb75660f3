package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** README's program runs as it is printed. */
class ReadmeJarTests {
    private static final Path BASE = Path
            .of(System.getProperty("occgrid.basedir"));
    private static final Pattern EXAMPLE = Pattern.compile(
            "```java\n((?s:.*?))```\n\nand run it:\n\n    (.*)\n\n"
                    + "It prints\n\n((?:    .*\n)+)");

    @TempDir
    private Path folder;

    @Test
    void theExampleRunsAsPrinted()
            throws IOException, InterruptedException {
        Matcher example = EXAMPLE
                .matcher(Files.readString(BASE.resolve("README.md")));
        assertTrue(example.find());
        // a folder like this one, to leave nothing here
        Path here = Files.createDirectory(folder.resolve("java"));
        Files.createSymbolicLink(here.resolve("target"),
                BASE.resolve("target"));
        Files.createSymbolicLink(folder.resolve("scenarios"),
                BASE.resolve("../scenarios").toRealPath());
        Files.writeString(here.resolve("TwoMaps.java"), example.group(1));
        Path out = folder.resolve("out");
        Process process = new ProcessBuilder("sh", "-c", example.group(2))
                .directory(here.toFile()).redirectErrorStream(true)
                .redirectOutput(out.toFile()).start();
        assertEquals(0, process.waitFor(), () -> read(out));
        assertEquals(example.group(3).replaceAll("(?m)^    ", ""),
                read(out));
        assertTrue(Files.readString(here.resolve("noisy.pgm"))
                .startsWith("P2\n220 180\n255\n"));
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException error) {
            throw new AssertionError(error);
        }
    }
}
