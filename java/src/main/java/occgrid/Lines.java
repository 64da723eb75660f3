package occgrid;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;

/**
 * The lines of a file, one after the other, and the fields of the line at
 * hand. The fields stay bytes: most of a log is numbers.
 */
final class Lines implements Closeable {
    private final SeekableByteChannel channel;
    private byte[] buffer = new byte[1 << 16];
    /** Where the buffer's first byte lies in the file. */
    private long offset;
    /** The line at hand, without its end; then what was read after it. */
    private int start;
    private int end;
    private int next;
    private int filled;
    /** Begin and end of each field in the buffer. */
    private int[] bounds = new int[64];
    private int size;
    private boolean isPlain;

    /** Opens a file; a folder opens, too, and cannot be read. */
    Lines(String path) throws IOException {
        if (path.isEmpty() || path.endsWith("/")) {
            // Path would drop the slash
            throw new IOException("a folder");
        }
        channel = Files.newByteChannel(FileNames.path(path));
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }

    // --- Lines ---

    /** Goes on to the next line; false at the end of the file. */
    boolean advance() throws IOException {
        // not BufferedReader: it ends lines at a lone CR too
        start = next;
        int at = next;
        while (true) {
            while (at < filled && buffer[at] != '\n') {
                at++;
            }
            if (at < filled) {
                next = at + 1;
                break;
            }
            int length = at - start;
            boolean isMore = fill();
            at = start + length;
            if (!isMore) {
                next = at;
                if (length == 0) {
                    return false;
                }
                break;
            }
        }
        end = at > start && buffer[at - 1] == '\r' ? at - 1 : at;
        split();
        return true;
    }

    /** Reads on behind the line that begins at start, which moves to 0. */
    private boolean fill() throws IOException {
        if (start > 0) {
            System.arraycopy(buffer, start, buffer, 0, filled - start);
            offset += start;
            filled -= start;
            start = 0;
        } else if (filled == buffer.length) {
            buffer = Arrays.copyOf(buffer, 2 * filled);
        }
        int count = channel.read(
                ByteBuffer.wrap(buffer, filled, buffer.length - filled));
        filled += Math.max(count, 0);
        return count > 0;
    }

    /** Where the line at hand begins in the file. */
    long position() {
        return offset + start;
    }

    /**
     * Goes to a place in the file, so that the next line is the one there.
     *
     * @throws IOException if the file cannot, as a pipe
     */
    void seek(long position) throws IOException {
        channel.position(position);
        offset = position;
        start = 0;
        next = 0;
        filled = 0;
    }

    // --- Fields of the line at hand ---

    /** Finds the fields between spaces and tabs. */
    private void split() {
        size = 0;
        isPlain = true;
        int at = start;
        while (at < end) {
            byte c = buffer[at];
            if (c == ' ' || c == '\t') {
                at++;
                continue;
            }
            int begin = at;
            while (at < end && (c = buffer[at]) != ' ' && c != '\t') {
                isPlain &= ' ' < c && c <= '~';
                at++;
            }
            if (2 * size == bounds.length) {
                bounds = Arrays.copyOf(bounds, 4 * size);
            }
            bounds[2 * size] = begin;
            bounds[2 * size + 1] = at;
            size++;
        }
    }

    /** Whether every byte is ASCII from space to ~, or a tab. */
    boolean isPlain() {
        return isPlain;
    }

    /** The number of fields. */
    int size() {
        return size;
    }

    /** The first byte of a field. */
    char first(int field) {
        return (char) (buffer[bounds[2 * field]] & 0xff);
    }

    /** A field as text; its bytes are ASCII, else Latin-1. */
    String text(int field) {
        int from = bounds[2 * field];
        return new String(buffer, from, bounds[2 * field + 1] - from,
                StandardCharsets.ISO_8859_1);
    }

    /**
     * A field as a number.
     *
     * @throws NumberFormatException if it is none
     */
    double number(int field) {
        return Numbers.parse(buffer, bounds[2 * field],
                bounds[2 * field + 1]);
    }
}
