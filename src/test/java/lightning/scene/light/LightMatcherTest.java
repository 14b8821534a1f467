package lightning.scene.light;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import net.jqwik.api.constraints.UniqueElements;
import org.junit.jupiter.api.Test;

/** Tests the matching of lights between two lists. */
class LightMatcherTest {
    private static final Light KEY = Light.of("key", LightType.SPOT).withIntensity(2);
    private static final Light FILL = Light.of("fill", LightType.POINT);
    private static final Light RIM = Light.of("rim", LightType.DIRECTIONAL);

    private static List<Integer> origins(List<Light> before, List<Light> after) {
        LightMatcher match = new LightMatcher(before, after);
        return IntStream.range(0, after.size()).mapToObj(match::originIndex).toList();
    }

    @Test
    void editedLight_isMatchedByName() {
        assertThat(origins(List.of(KEY, FILL), List.of(FILL.withIntensity(9), KEY))).containsExactly(1, 0);
    }

    @Test
    void renamedLight_isMatchedByEquality() {
        assertThat(origins(List.of(KEY, FILL, RIM), List.of(RIM, KEY.withName("sun")))).containsExactly(2, 0);
    }

    @Test
    void renamedAndEditedLight_isMatchedByIndex() {
        assertThat(origins(List.of(KEY, FILL), List.of(KEY.withName("sun").withIntensity(7), FILL))).containsExactly(0, 1);
    }

    @Test
    void newLight_hasNoOrigin() {
        assertThat(origins(List.of(KEY), List.of(KEY, FILL))).containsExactly(0, -1);
    }

    @Test
    void lightAtIndexOfMovedLight_isNew() {
        assertThat(origins(List.of(KEY, FILL), List.of(RIM, KEY))).containsExactly(-1, 0);
    }

    @Test
    void deletedLight_isRemoved() {
        assertThat(new LightMatcher(List.of(KEY, FILL, RIM), List.of(KEY, RIM)).removedIndices()).containsExactly(1);
    }

    @Test
    void renamedLight_isMatched() {
        assertThat(new LightMatcher(List.of(KEY, FILL), List.of(KEY.withOn(false), FILL.withName("sun"))).originIndex(1)).isEqualTo(1);
    }

    @Test
    void swappedLights_areMatchedByName() {
        assertThat(new LightMatcher(List.of(KEY, FILL), List.of(FILL, KEY)).originIndex(0)).isEqualTo(1);
    }

    @Property
    void everyOldLight_isMatchedAtMostOnce(
            @ForAll @Size(max = 6) @UniqueElements List<@IntRange(max = 7) Integer> before,
            @ForAll @Size(max = 6) @UniqueElements List<@IntRange(max = 7) Integer> after,
            @ForAll @IntRange(max = 3) int edited) {
        LightMatcher match = new LightMatcher(lights(before, 0), lights(after, edited));
        List<Integer> all = new ArrayList<>(match.removedIndices());
        for (int i = 0; i < after.size(); i++) {
            if (match.originIndex(i) >= 0) {
                all.add(match.originIndex(i));
            }
        }
        assertThat(all).containsExactlyInAnyOrderElementsOf(IntStream.range(0, before.size()).boxed().toList());
    }

    /** Returns lights of these names; every {@code edited}-th, if that is not 0, is brighter. */
    private static List<Light> lights(List<Integer> names, int edited) {
        return names.stream().map(n -> Light.of("l" + n, LightType.POINT).withIntensity(edited > 0 && n % edited == 0 ? 3 : 1)).toList();
    }
}
