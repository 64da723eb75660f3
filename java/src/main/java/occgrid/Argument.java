package occgrid;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * An argument of the command line. Java hands it over as text, and puts ? or
 * U+FFFD where the locale's character set does not have its bytes; such a
 * text would name another file.
 *
 * @param text as Java hands it over
 * @param bytes its bytes, each as a character of Latin-1; U+FFFD for one
 *        that is not known
 */
record Argument(String text, String bytes) {
    /** An argument that is what it looks like. */
    static Argument of(String text) {
        return new Argument(text, latin1(text.getBytes(FileNames.CHARSET)));
    }

    /** The arguments of this process. */
    static List<Argument> ofCommandLine(String[] texts) {
        try {
            // Linux has the bytes: those of the virtual machine's own
            // arguments, then those of the program's
            byte[] line = Files.readAllBytes(Path.of("/proc/self/cmdline"));
            return ofCommandLine(texts, latin1(line));
        } catch (IOException error) {
            return Stream.of(texts).map(Argument::ofText).toList();
        }
    }

    /** The arguments of a process, all of whose bytes end with NUL each. */
    static List<Argument> ofCommandLine(String[] texts, String line) {
        String[] all = line.split("\0", -1);
        // behind the last NUL there is nothing
        int first = all.length - 1 - texts.length;
        if (first < 0) {
            return Stream.of(texts).map(Argument::ofText).toList();
        }
        String[] last = Arrays.copyOfRange(all, first, all.length - 1);
        return IntStream.range(0, texts.length)
                .mapToObj(i -> new Argument(texts[i], last[i])).toList();
    }

    /** An argument whose bytes are not known: U+FFFD stands for others. */
    private static Argument ofText(String text) {
        return text.indexOf('\ufffd') < 0
                ? of(text)
                : new Argument(text, text);
    }

    /** Whether the text has these bytes, so that files can be opened by it. */
    boolean isExact() {
        return of(text).bytes.equals(bytes);
    }

    private static String latin1(byte[] bytes) {
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }
}
