package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class ArgumentTest {
    @Test
    void theBytesAreThoseOfTheLastArguments() {
        List<Argument> arguments = Argument.ofCommandLine(
                new String[]{"--out", "?", "", "\ufffd.log"},
                "java\0-jar\0x.jar\0--out\0\u00e4\0\0\u00ff.log\0");
        assertTrue(arguments.get(0).isExact());
        assertFalse(arguments.get(1).isExact());
        assertEquals("\u00e4", arguments.get(1).bytes());
        assertTrue(arguments.get(2).isExact());
        assertFalse(arguments.get(3).isExact());
        assertTrue(Argument.ofCommandLine(new String[]{"?.log"},
                "java\0?.log\0").get(0).isExact());
        assertEquals(List.of(),
                Argument.ofCommandLine(new String[]{}, "java\0x\0"));
    }

    @Test
    void withoutTheBytes() {
        List<Argument> arguments = Argument
                .ofCommandLine(new String[]{"a", "\ufffd"}, "");
        assertTrue(arguments.get(0).isExact());
        assertFalse(arguments.get(1).isExact());
    }
}
