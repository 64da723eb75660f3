package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The modules use those before them, so that there is no circle. */
class ModulesTest {
    /** The modules in their order, each with the files that serve it. */
    private static final List<List<String>> MODULES = List.of(
            List.of("PortableMath"), List.of("Noise"), List.of("Grid"),
            List.of("Ray"), List.of("World"), List.of("Sensor"),
            List.of("FileNames"),
            List.of("Scenario", "ScenarioReader", "Parameters", "Lines",
                    "Numbers"),
            List.of("Lesson"), List.of("Mapper"),
            List.of("Fast", "Beams", "SinCos", "Bands"),
            List.of("MapWriter", "OutputFiles"),
            List.of("Main", "Options", "Argument"));

    private static final Path MAIN = Path.of(
            System.getProperty("occgrid.basedir"), "src/main/java/occgrid");

    /** The source without comments. */
    private static String code(String name) throws IOException {
        return Files.readString(MAIN.resolve(name + ".java"))
                .replaceAll("(?s)/\\*.*?\\*/", "").replaceAll("//.*", "");
    }

    @Test
    void everyModuleUsesThoseBeforeIt() throws IOException {
        for (int i = 0; i < MODULES.size(); i++) {
            for (String name : MODULES.get(i)) {
                String code = code(name);
                for (List<String> later : MODULES.subList(i + 1,
                        MODULES.size())) {
                    for (String other : later) {
                        assertFalse(code.matches(
                                "(?s).*\\b" + other + "\\b.*"),
                                name + " uses " + other);
                    }
                }
            }
        }
    }

    @Test
    void everyFileBelongsToAModule() throws IOException {
        try (Stream<Path> files = Files.list(MAIN)) {
            Set<String> sources = files
                    .map(file -> file.getFileName().toString()
                            .replace(".java", ""))
                    .collect(Collectors.toCollection(TreeSet::new));
            Set<String> known = new TreeSet<>();
            MODULES.forEach(known::addAll);
            assertEquals(known, sources);
        }
    }
}
