package lightning.scene;

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

/** Which light of an edited list goes on from which of the list before. */
class LightMatchTest {
    private static final Light KEY = Light.of("key", LightType.SPOT).withIntensity(2);
    private static final Light FILL = Light.of("fill", LightType.POINT);
    private static final Light RIM = Light.of("rim", LightType.DIRECTIONAL);

    private static List<Integer> origins(List<Light> before, List<Light> after) {
        LightMatch match = new LightMatch(before, after);
        return IntStream.range(0, after.size()).mapToObj(match::origin).toList();
    }

    @Test
    void editedLight_isFoundByItsName() {
        assertThat(origins(List.of(KEY, FILL), List.of(FILL.withIntensity(9), KEY))).containsExactly(1, 0);
    }

    @Test
    void renamedLight_goesOnFromTheOneThatIsAlike() {
        assertThat(origins(List.of(KEY, FILL, RIM), List.of(RIM, KEY.withName("sun")))).containsExactly(2, 0);
    }

    @Test
    void renamedAndEditedLight_goesOnFromTheOneInItsPlace() {
        assertThat(origins(List.of(KEY, FILL), List.of(KEY.withName("sun").withIntensity(7), FILL))).containsExactly(0, 1);
    }

    @Test
    void newLight_goesOnFromNone() {
        assertThat(origins(List.of(KEY), List.of(KEY, FILL))).containsExactly(0, -1);
    }

    @Test
    void lightInThePlaceOfOneThatMoved_isNew() {
        assertThat(origins(List.of(KEY, FILL), List.of(RIM, KEY))).containsExactly(-1, 0);
    }

    @Test
    void deletedLight_isGone() {
        assertThat(new LightMatch(List.of(KEY, FILL, RIM), List.of(KEY, RIM)).gone()).containsExactly(1);
    }

    @Test
    void editedLights_keepTheirPlaces() {
        assertThat(new LightMatch(List.of(KEY, FILL), List.of(KEY.withOn(false), FILL.withName("sun"))).keepsPlaces()).isTrue();
    }

    @Test
    void swappedLights_doNotKeepTheirPlaces() {
        assertThat(new LightMatch(List.of(KEY, FILL), List.of(FILL, KEY)).keepsPlaces()).isFalse();
    }

    @Property
    void everyLightBefore_hasAtMostOneThatGoesOnFromIt(
            @ForAll @Size(max = 6) @UniqueElements List<@IntRange(max = 7) Integer> before,
            @ForAll @Size(max = 6) @UniqueElements List<@IntRange(max = 7) Integer> after,
            @ForAll @IntRange(max = 3) int edited) {
        LightMatch match = new LightMatch(lights(before, 0), lights(after, edited));
        List<Integer> all = new ArrayList<>(match.gone());
        for (int i = 0; i < after.size(); i++) {
            if (match.origin(i) >= 0) {
                all.add(match.origin(i));
            }
        }
        assertThat(all).containsExactlyInAnyOrderElementsOf(IntStream.range(0, before.size()).boxed().toList());
    }

    /** Lights of these names; every {@code edited}-th, if that is not 0, is brighter. */
    private static List<Light> lights(List<Integer> names, int edited) {
        return names.stream().map(n -> Light.of("l" + n, LightType.POINT).withIntensity(edited > 0 && n % edited == 0 ? 3 : 1)).toList();
    }
}
