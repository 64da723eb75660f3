package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import occgrid.Scenario.ScenarioException;
import org.junit.jupiter.api.Test;

/** The bad scenarios that all ports share, in scenarios/bad. */
class BadScenariosTest {
    private static final Path SHARED = Path
            .of(System.getProperty("occgrid.basedir"), "../scenarios/bad");

    private static ScenarioException error(String file) {
        return assertThrows(ScenarioException.class, () -> {
            try (Scenario scenario = Scenario
                    .readScenario(SHARED.resolve(file).toString())) {
                scenario.scans().forEach(scan -> {
                });
            }
        }, file);
    }

    @Test
    void everyErrorIsTheExpectedOne() throws IOException {
        assertTrue(Files.isDirectory(SHARED), SHARED + " is missing");
        List<String> expected = Files
                .readAllLines(SHARED.resolve("expected.txt"));
        assertTrue(expected.size() >= 300);
        for (String line : expected) {
            String file = line.substring(0, line.indexOf(':'));
            ScenarioException error = error(file);
            assertEquals(line,
                    file + ":" + error.line + ": " + error.reason);
        }
    }
}
