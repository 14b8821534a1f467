package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class ParetoFrontTest {
    private record Setting(String name, double time, double error) {}

    @Test
    void settingsBeatenInTimeAndError_areOmitted() {
        List<Setting> settings = List.of(new Setting("slow", 9, 1), new Setting("fast", 1, 8), new Setting("beaten", 5, 6),
                new Setting("middle", 4, 5), new Setting("equal error", 6, 5));
        assertThat(ParetoFront.of(settings, Setting::time, Setting::error)).extracting(Setting::name)
                .containsExactly("fast", "middle", "slow");
    }

    @Test
    void oneOfEqualSettings_isKept() {
        assertThat(ParetoFront.of(List.of(new Setting("a", 1, 1), new Setting("b", 1, 1)), Setting::time, Setting::error)).hasSize(1);
    }
}
