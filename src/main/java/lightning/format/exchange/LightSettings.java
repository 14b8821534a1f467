package lightning.format.exchange;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.format.gltf.GltfLight;
import lightning.format.mesh.Notes;
import lightning.scene.Bank;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Rig;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * All that a scene says of a light, in the {@code extras} of the light that glTF has in its place. What glTF has too counts as glTF says it
 * where another program changed it since.
 */
final class LightSettings {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final String UNITS = "light_units";
    private static final String BANK = "bank_settings";
    /** Files hold floats. */
    private static final double SAME = 1e-5;

    private final Pieces pieces;
    private final Map<String, Bank> banks = new HashMap<>();

    /** @param pieces gets the light groups, and the notes of what cannot be restored */
    LightSettings(Pieces pieces) {
        this.pieces = pieces;
    }

    /**
     * What goes into the extras.
     *
     * @param units what the numbers of glTF are
     */
    static ObjectNode of(Light light, Rig rig, LightUnits units) {
        ObjectNode out = JSON.createObjectNode().put(UNITS, units.name().toLowerCase(Locale.ROOT));
        AttributeJson.write(out, light, LightAttribute.ALL);
        rig.bank(light.bank()).ifPresent(bank -> AttributeJson.write(out.putObject(BANK), bank, Bank.ATTRIBUTES));
        return out;
    }

    /**
     * The light that was written, where glTF's still is what was written of it.
     *
     * @param made  as glTF says it
     * @param found what glTF says
     * @return {@code made} itself where this program did not write it
     */
    Light restored(Light made, GltfLight found) {
        JsonNode own = found.own();
        Optional<LightUnits> units = Stream.of(LightUnits.values())
                .filter(u -> own.path(UNITS).asString("").equals(u.name().toLowerCase(Locale.ROOT))).findFirst();
        if (units.isEmpty()) {
            return made;
        }
        Light said = AttributeJson.read(own, made, LightAttribute.ALL, pieces::finds, _ -> refuse());
        Optional<Bank> bank = bank(said, own.path(BANK));
        GltfLight written =
                PunctualLight.of(bank.map(b -> Rig.of(List.of(said), List.of(b)).acting(said)).orElse(said), units.get(), own, new Notes());
        Light light = said;
        if (!isSameShape(written, found)) {
            light = light.withType(made.type()).withAngle(made.angle()).withDropoff(made.dropoff());
        }
        if (made.type().hasPosition() && !isNear(made.position(), said.position(), Math.max(1, made.position().maxAbs()))) {
            light = light.withPosition(made.position());
        }
        if (made.type().hasDirection() && !isNear(made.direction().normalized(), said.direction().normalized(), 1)) {
            light = light.withDirection(made.direction());
        }
        if (!isSameStrength(written, found)) {
            return light.withColor(made.color()).withIntensity(made.intensity()).withAttenuation(made.attenuation()).withBank("");
        }
        pieces.restored.add(made.name());
        return bank.isEmpty() ? light.withBank("") : light.withBank(known(bank.get()));
    }

    private void refuse() {
        pieces.notes.add("settings of lights that cannot be used here");
    }

    private Optional<Bank> bank(Light said, JsonNode settings) {
        return said.bank().isEmpty() ? Optional.empty()
                : Optional.of(AttributeJson.read(settings, Bank.of(said.bank()), Bank.ATTRIBUTES, pieces::finds, _ -> refuse()));
    }

    /** The name of the scene's bank; the first of a name stands for the others. */
    private String known(Bank bank) {
        return banks.computeIfAbsent(bank.name(), name -> {
            Bank free = bank.withName(pieces.names.unique(name, "bank"));
            pieces.banks.add(free);
            return free;
        }).name();
    }

    private static boolean isSameShape(GltfLight a, GltfLight b) {
        return a.type() == b.type() && (a.type() != GltfLight.Type.SPOT || isNear(a.inner(), b.inner()) && isNear(a.outer(), b.outer()));
    }

    private static boolean isSameStrength(GltfLight a, GltfLight b) {
        Rgb one = a.color().times(a.intensity());
        Rgb other = b.color().times(b.intensity());
        return isNear(one.r(), other.r()) && isNear(one.g(), other.g()) && isNear(one.b(), other.b());
    }

    private static boolean isNear(double a, double b) {
        return Math.abs(a - b) <= SAME * Math.max(Math.abs(a), Math.abs(b));
    }

    private static boolean isNear(Vec3 a, Vec3 b, double size) {
        return a.minus(b).maxAbs() <= SAME * size;
    }
}
