package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.Options;
import lightning.render.shading.Luminaire;
import lightning.render.shading.TraceCounts;
import lightning.sample.StudioScene;
import org.junit.jupiter.api.Test;

class BankTest {
    private static final Bank LEFT = Bank.of("left");
    private static final Light KEY = Light.of("key", LightType.POINT).withColor(new Rgb(1, 0.5, 0.25)).withIntensity(3).withBank("left");
    private static final Light FREE = Light.of("free", LightType.POINT);

    private static Rig rig(Bank... banks) {
        return Rig.of(List.of(KEY, FREE), List.of(banks));
    }

    private static Light acting(Rig rig, String light) {
        return rig.acting(rig.light(light).orElseThrow());
    }

    @Test
    void colourAndIntensity_areFactorsOfItsLightsOnly() {
        Rig rig = rig(LEFT.withColor(new Rgb(0.5, 1, 0)).withIntensity(2));
        assertThat(acting(rig, "key")).isEqualTo(KEY.withBank("").withColor(new Rgb(0.5, 0.5, 0)).withIntensity(6));
        assertThat(acting(rig, "free")).isEqualTo(FREE);
    }

    @Test
    void intensityBeyondWhatALightMayHave_isTheMost() {
        Rig rig = rig(LEFT.withIntensity(1000)).with(KEY.withIntensity(1e30));
        assertThat(acting(rig, "key").intensity()).isEqualTo(Limits.MAX_INTENSITY);
    }

    @Test
    void bankThatIsOff_darkensItsLightsAlone() {
        Rig rig = rig(LEFT.withOn(false));
        assertThat(rig.shines(KEY)).isFalse();
        assertThat(rig.shines(FREE)).isTrue();
    }

    @Test
    void soloBank_darkensAllOthers() {
        Rig rig = rig(LEFT.withSolo(true));
        assertThat(rig.shines(KEY)).isTrue();
        assertThat(rig.shines(FREE)).isFalse();
        assertThat(rig.with(LEFT.withSolo(true).withOn(false)).shines(FREE)).as("it is off").isTrue();
        assertThat(rig.with(KEY.withOn(false)).shines(FREE)).as("none of its lights is on").isTrue();
    }

    @Test
    void renamedBank_keepsItsLights() {
        assertThat(rig(LEFT).renamed("left", "right")).isEqualTo(Rig.of(List.of(KEY.withBank("right"), FREE), List.of(Bank.of("right"))));
    }

    @Test
    void deletedBank_leavesItsLightsInNone() {
        assertThat(rig(LEFT).without("left")).isEqualTo(Rig.of(List.of(KEY.withBank(""), FREE)));
    }

    @Test
    void lightOfAMissingBank_isRefused() {
        assertThatThrownBy(() -> rig(Bank.of("right"))).hasMessage("light 'key': there is no bank 'left'");
    }

    @Test
    void nameThatIsTaken_isRefused() {
        assertThatThrownBy(() -> rig(LEFT, LEFT)).hasMessage("bank 'left': the name is already taken");
        assertThatThrownBy(() -> rig(LEFT, Bank.of("free"))).hasMessage("bank 'free': the name is already taken");
        Scene studio = StudioScene.of(LightType.POINT);
        String shape = studio.nodes().getFirst().name();
        assertThatThrownBy(() -> studio.withRig(studio.rig().plus(Bank.of(shape))))
                .hasMessage("bank '" + shape + "': the name is already taken");
    }

    @Test
    void changesOfBanks_areToldInWords() {
        Scene studio = StudioScene.of(LightType.POINT);
        Scene banked = studio.withRig(studio.rig().plus(LEFT));
        assertThat(SceneChange.text(studio, banked)).isEqualTo("add left");
        assertThat(SceneChange.text(banked, studio)).isEqualTo("delete left");
        assertThat(SceneChange.text(banked, banked.withRig(banked.rig().with(LEFT.withIntensity(0.5).withOn(false)))))
                .isEqualTo("left: intensity 1 → 0.5, on yes → no");
        assertThat(SceneChange.text(banked, banked.withRig(banked.rig().renamed("left", "rear")))).isEqualTo("left: name left → rear");
    }

    /** However many lights it has: no ray is cast, no column is written, and where nothing is seen nothing is composed. */
    @Test
    void everyEditOfABank_onlyComposes() {
        Scene studio = StudioScene.of(LightType.SPOT);
        Rig rig = Rig.of(studio.lights().stream().map(l -> l.withBank("left")).toList(), List.of(LEFT));
        try (Renderer renderer = new Renderer(Options.DEFAULT.withThreads(1))) {
            renderer.render(studio.withRig(rig), Progress.NONE);
            List<Rig> edits =
                    Stream.of(LEFT.withColor(new Rgb(1, 0, 0)), LEFT.withIntensity(0.5), LEFT.withOn(false), LEFT, LEFT.withSolo(true))
                            .map(rig::with).toList();
            for (Rig edited : edits) {
                var update = renderer.render(studio.withRig(edited), Progress.NONE);
                assertThat(update.rays()).as(update.plan().text()).isEqualTo(TraceCounts.NONE);
                assertThat(update.rowsTouched()).isZero();
            }
            var renamed = renderer.render(studio.withRig(edits.getLast().renamed("left", "right")), Progress.NONE);
            assertThat(renamed.rowsComposed()).isZero();
        }
    }

    /** Absent is free: a rig without banks hands its lights on, and those that a bank leaves alone keep every bit. */
    @Test
    void lightsInNoBank_areTheVeryLights() {
        Rig plain = Rig.of(List.of(FREE), List.of(LEFT));
        assertThat(plain.actingLights()).isSameAs(plain.lights());
        Scene studio = StudioScene.of(LightType.SPOT);
        Scene banked = studio.withRig(Rig.of(studio.lights().stream().map(l -> l.withBank("left")).toList(), List.of(LEFT)));
        assertThat(Luminaire.all(banked)).isEqualTo(Luminaire.all(studio));
        assertThat(VisiblePart.same(studio, banked)).isTrue();
    }
}
