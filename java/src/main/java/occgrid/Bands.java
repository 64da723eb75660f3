package occgrid;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import occgrid.Grid.OccupancyGrid;
import occgrid.Scenario.Settings;
import occgrid.Sensor.Scan;

/**
 * Several threads at one grid, with the same bits for any number of them.
 *
 * <p>
 * They take a batch of scans. First each finds the beams of some of the
 * scans. Then each owns a band of the grid's rows, and takes the updates of
 * its rows by all beams in order: no cell has two owners. With rows 0 to 9
 * and 10 to 19 of 20, a beam from row 5 to row 15 is walked by both threads,
 * by each over its own rows. Meanwhile the calling thread reads the next
 * batch.
 */
final class Bands {
    /** Beams that are updated together: bounds the memory. */
    private static final int BATCH_BEAMS = 1 << 16;

    /**
     * Rows of a grid; none if last is below first.
     *
     * @param first the first of them
     * @param last the last of them
     */
    record Rows(int first, int last) {
    }

    private final OccupancyGrid grid;
    private final Settings settings;
    private final int threads;
    private final ExecutorService workers;
    /** The beams of the batch at work: a list for each thread, in order. */
    private final List<Beams> beams;

    private Bands(OccupancyGrid grid, Settings settings, int threads) {
        this.grid = grid;
        this.settings = settings;
        this.threads = threads;
        workers = Executors.newFixedThreadPool(threads);
        beams = Stream.generate(Beams::new).limit(threads).toList();
    }

    /** Updates a grid from scans, in order. */
    static void update(OccupancyGrid grid, Iterable<Scan> scans,
            Settings settings, int threads) {
        Bands bands = new Bands(grid, settings, threads);
        try {
            Iterator<Scan> rest = scans.iterator();
            List<Scan> batch = nextBatch(rest);
            while (!batch.isEmpty()) {
                CompletableFuture<Void> mapped = bands.update(batch);
                batch = nextBatch(rest);
                mapped.join();
            }
        } catch (CompletionException error) {
            if (error.getCause() instanceof RuntimeException cause) {
                throw cause;
            }
            throw error;
        } finally {
            bands.workers.shutdownNow();
        }
    }

    private static List<Scan> nextBatch(Iterator<Scan> scans) {
        List<Scan> batch = new ArrayList<>();
        for (int beams = 0; beams < BATCH_BEAMS && scans.hasNext();) {
            Scan scan = scans.next();
            batch.add(scan);
            beams += scan.ranges().length;
        }
        return batch;
    }

    /** Sets the workers to a batch. */
    private CompletableFuture<Void> update(List<Scan> batch) {
        CompletableFuture<?>[] found = IntStream.range(0, threads)
                .mapToObj(thread -> CompletableFuture.runAsync(
                        () -> find(batch, thread), workers))
                .toArray(CompletableFuture<?>[]::new);
        return CompletableFuture.allOf(found).thenCompose(done -> {
            CompletableFuture<?>[] updated = cutBands(beams,
                    settings.height(), threads).stream()
                    .map(rows -> CompletableFuture
                            .runAsync(() -> updateRows(rows), workers))
                    .toArray(CompletableFuture<?>[]::new);
            return CompletableFuture.allOf(updated);
        });
    }

    /** Finds the beams of a thread's part of the scans. */
    private void find(List<Scan> batch, int thread) {
        Beams mine = beams.get(thread);
        mine.clear();
        int from = batch.size() * thread / threads;
        int to = batch.size() * (thread + 1) / threads;
        for (Scan scan : batch.subList(from, to)) {
            mine.append(grid, scan, settings.maxRange(),
                    settings.noReturn());
        }
    }

    private void updateRows(Rows rows) {
        for (Beams some : beams) {
            some.updateRows(grid, rows.first(), rows.last());
        }
    }

    /**
     * Cuts the rows 0 .. height - 1 into bands, in order, that take about as
     * many updates by these beams each. Some may be empty.
     *
     * @param beams the beams
     * @param height number of rows
     * @param count number of bands
     * @return the bands
     */
    static List<Rows> cutBands(List<Beams> beams, int height, int count) {
        // how many more cells a row has of the beams than the row before
        double[] rise = new double[height + 1];
        double all = 0.0;
        for (Beams some : beams) {
            // a thousand of them say enough
            int step = 1 + some.size() / 1024;
            for (int i = 0; i < some.size(); i += step) {
                int low = Math.min(some.gy0(i), some.gy1(i));
                int high = Math.max(some.gy0(i), some.gy1(i));
                int first = Math.max(low, 0);
                int last = Math.min(high, height - 1);
                if (first > last) {
                    continue;
                }
                double columns = Math.abs(some.gx1(i) - some.gx0(i));
                double inRow = Math.max(1.0, columns / (high - low + 1.0));
                rise[first] += inRow;
                rise[last + 1] -= inRow;
                all += inRow * (last - first + 1);
            }
        }
        List<Rows> bands = new ArrayList<>();
        int row = 0;
        double inRow = 0.0;
        double before = 0.0;
        for (int band = 1; band <= count; band++) {
            int first = row;
            while (row < height
                    && (band == count || before < all * band / count)) {
                inRow += rise[row];
                before += inRow;
                row++;
            }
            bands.add(new Rows(first, row - 1));
        }
        return bands;
    }
}
