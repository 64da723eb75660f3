import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import java.util.OptionalLong;
import occgrid.Fast;
import occgrid.Grid;
import occgrid.Grid.Cell;
import occgrid.Grid.OccupancyGrid;
import occgrid.Mapper;
import occgrid.Scenario;
import org.junit.jupiter.api.Test;

/** Only what is public, only from the jar. */
class ConsumerTest {
    private static final String LESSON = System.getProperty("scenarios")
            + "/lesson.log";

    @Test
    void theClassesComeFromTheInstalledJar() {
        String place = Fast.class.getProtectionDomain().getCodeSource()
                .getLocation().getPath();
        assertTrue(place.contains("/it-repository/"), place);
        assertTrue(place.endsWith(".jar"), place);
    }

    @Test
    void theLessonIsMapped() {
        Locale.setDefault(Locale.GERMANY);
        try (Scenario lesson = Scenario.readScenario(LESSON)) {
            OccupancyGrid grid = Fast.mapScenarioFast(lesson,
                    OptionalLong.empty());
            Cell cell = grid.worldToGrid(0.0, 2.0);
            assertEquals(0.9892011065412029,
                    Grid.sigmoid(grid.logOdds(cell.gx(), cell.gy())));
            assertArrayEquals(grid.logOdds(), Mapper
                    .mapScenario(lesson, OptionalLong.empty()).logOdds());
        }
    }
}
