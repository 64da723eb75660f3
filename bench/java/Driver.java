import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.StringTokenizer;

/**
 * What the Java programs of the benchmark share: the work, and the answers to
 * the benchmark's requests (see cpp/driver.hpp).
 */
final class Driver {
    /** One scan: pose in metres and radians, ranges (beams) in metres. */
    record WorkScan(double x, double y, double theta, double[] ranges) {
    }

    /** Poses and ranges that every contestant maps; metres, radians. */
    record Work(int width, int height, double resolution, double originX,
            double originY, double maxRange, double[] angles,
            WorkScan[] scans) {
    }

    /** Maps the work into a grid of its own; writes what it mapped last. */
    interface Mapping {
        void map();

        void write(OutputStream out) throws IOException;
    }

    private Driver() {
    }

    static Work readWork(String file) throws IOException {
        try (BufferedReader in = Files.newBufferedReader(Path.of(file))) {
            double[] head = numbers(in.readLine());
            double[] angles = numbers(in.readLine());
            WorkScan[] scans = new WorkScan[(int) head[6]];
            for (int s = 0; s < scans.length; s++) {
                double[] line = numbers(in.readLine());
                double[] ranges = new double[angles.length];
                System.arraycopy(line, 3, ranges, 0, ranges.length);
                scans[s] = new WorkScan(line[0], line[1], line[2], ranges);
            }
            return new Work((int) head[0], (int) head[1], head[2], head[3],
                    head[4], head[5], angles, scans);
        }
    }

    private static double[] numbers(String line) {
        StringTokenizer words = new StringTokenizer(line);
        double[] numbers = new double[words.countTokens()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = Double.parseDouble(words.nextToken());
        }
        return numbers;
    }

    /** Answers requests until the input ends. */
    static void answerRequests(Mapping mapping) throws IOException {
        BufferedReader in = new BufferedReader(
                new InputStreamReader(System.in));
        for (String line; (line = in.readLine()) != null;) {
            String[] request = line.split(" ", 2);
            if (request[0].equals("map")) {
                for (int i = Integer.parseInt(request[1]); i > 0; i--) {
                    long start = System.nanoTime();
                    mapping.map();
                    long end = System.nanoTime();
                    System.out.print((end - start) / 1e9 + " ");
                }
                System.out.println();
            } else {
                try (OutputStream out = Files
                        .newOutputStream(Path.of(request[1]))) {
                    mapping.write(out);
                }
                System.out.println("written");
            }
        }
    }
}
