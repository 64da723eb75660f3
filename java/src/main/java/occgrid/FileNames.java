package occgrid;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;

/**
 * File names between Java, which has them as text, and the system, which has
 * them as bytes. They meet in the locale's character set; a name outside it
 * has no text.
 */
final class FileNames {
    /** The character set of file names. */
    static final Charset CHARSET = charset();

    private FileNames() {
    }

    private static Charset charset() {
        String name = System.getProperty("sun.jnu.encoding", "UTF-8");
        return Charset.isSupported(name)
                ? Charset.forName(name)
                : StandardCharsets.UTF_8;
    }

    /**
     * The path of a name.
     *
     * @throws IOException if the locale's character set does not have the
     *         name; java.io.File would open another one, with ? in it
     */
    static Path path(String name) throws IOException {
        try {
            return Path.of(name);
        } catch (InvalidPathException error) {
            throw new IOException(error);
        }
    }

    /** A name or message as bytes, on one line: control characters as ?. */
    static byte[] bytes(String text) {
        return onOneLine(text).getBytes(CHARSET);
    }

    /** A text where ? stands for each control character. */
    static String onOneLine(String text) {
        return text.replaceAll("[\\x00-\\x1f\\x7f]", "?");
    }

    /** A name without the slashes at its end; of a root one stays. */
    static String withoutSlashes(String name) {
        int end = name.length();
        while (end > 1 && name.charAt(end - 1) == '/') {
            end--;
        }
        return name.substring(0, end);
    }
}
