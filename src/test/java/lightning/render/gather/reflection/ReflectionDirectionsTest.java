package lightning.render.gather.reflection;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.HashSet;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Directions of the copies of a reflection point. */
class ReflectionDirectionsTest {
    @Property
    void pointAndThreeCopies_shareNoRowAndNoColumnOfParts(@ForAll long seed) {
        Set<Long> rows = new HashSet<>();
        Set<Long> columns = new HashSet<>();
        for (int copy = 0; copy < 4; copy++) {
            long part = ReflectionDirections.seed(seed, copy) & 15;
            rows.add(part / 4);
            columns.add(part % 4);
        }
        assertEquals(4, rows.size());
        assertEquals(4, columns.size());
    }

    @Property
    void sixteenCopies_coverAllParts(@ForAll long seed, @ForAll @IntRange(min = 0, max = 15) int part) {
        int found = 0;
        for (int copy = 0; copy < 16; copy++) {
            found += (ReflectionDirections.seed(seed, copy) & 15) == part ? 1 : 0;
        }
        assertEquals(1, found);
    }
}
