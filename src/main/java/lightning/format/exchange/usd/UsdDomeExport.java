package lightning.format.exchange.usd;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.jen.asset.FileKind;
import lightning.format.mesh.ConversionNotes;
import lightning.format.usd.UsdLayer;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import lightning.scene.value.DomeRotation;

/**
 * Writer of what has been edited of the environments.
 *
 * @param layer receives the edits
 * @param writer writer of single attributes
 * @param notes receives what cannot be written
 * @param create defines a dome light of a name
 */
public record UsdDomeExport(UsdLayer layer, UsdPrimWriter writer, ConversionNotes notes, Function<String, UsdLayer.Prim> create) {
    /** Values of an environment that a dome light has. */
    private record Values(double intensity, DomeRotation rotation) {}

    /** Returns the image of the physical sky, which has no file; empty without a sky. */
    public static Optional<EnvironmentMap> sky(World world) {
        return world.sky().on() ? world.environment().map(Environment::map) : Optional.empty();
    }

    /** Returns the sun of the physical sky as a light; empty without one, or if it is dark. */
    public static Optional<Light> sun(Scene scene) {
        if (!scene.world().sky().on()) {
            return Optional.empty();
        }
        Light sun = scene.rig().effectiveLights().get(scene.rig().environmentStart(0));
        return Optional.of(sun.withArea(sun.area().withSpread(scene.world().sky().sunRadius()))).filter(l -> !l.weight().isBlack());
    }

    /**
     * Writes the edits; removes the dome lights whose environments the scene does not have.
     *
     * @param skyImage name, relative to the layer, of an image of the physical sky
     */
    public void add(Scene scene, String skyImage) throws IOException {
        World world = scene.world();
        for (Dome dome : world.domes()) {
            add(dome, skyImage);
        }
        for (Map.Entry<String, UsdPaths.Dome> original : writer.paths().domes().entrySet()) {
            if (world.domeOrOwn(original.getKey()).filter(Dome::isPresent).isEmpty()) {
                remove(original.getValue());
            }
        }
        noteSolos(scene);
    }

    private void add(Dome dome, String skyImage) throws IOException {
        if (!dome.isPresent()) {
            notes.add("domes without an image", dome.isOwn() ? 0 : 1);
            return;
        }
        Optional<UsdPaths.Dome> original = Optional.ofNullable(writer.paths().domes().get(dome.name()));
        boolean isSky = dome.sky().on();
        String file = isSky ? "" : dome.image().orElseThrow().file();
        write(original, dome.isOwn() ? "environment" : dome.name(), new Values(dome.on() ? dome.intensity() : 0, dome.rotation()),
                isSky ? UsdLayer.asset("./" + skyImage) : writer.asset(FileKind.ENVIRONMENT, file), isSky || isOther(original, file));
        notes.add("discs of suns, which are distant lights", isSky && dome.sky().sun() > 0 ? 1 : 0);
        notes.add("domes that are off, written with an intensity of 0", dome.on() ? 0 : 1);
        notes.add(dome.isOwn() ? "light gain of the environment" : "light gain of domes", dome.gain() == 1 ? 0 : 1);
    }

    private void noteSolos(Scene scene) {
        List<Dome> environments = scene.world().environments();
        for (int i = 0; i < environments.size(); i++) {
            notes.add("environments that a solo mutes, written as lit",
                    environments.get(i).on() && !scene.rig().isEnvironmentActive(i) ? 1 : 0);
        }
    }

    private boolean isOther(Optional<UsdPaths.Dome> original, String file) {
        return original.isEmpty() || !writer.paths().isSameFile(original.get().file(), file);
    }

    private void remove(UsdPaths.Dome dome) {
        layer.prim(dome.prim().path()).metadata("active", "false");
    }

    /** Writes what differs from the original. */
    private void write(Optional<UsdPaths.Dome> dome, String name, Values values, String asset, boolean isImage) {
        boolean isBrightness =
                dome.isEmpty() || dome.get().intensity().isEmpty() || dome.get().intensity().getAsDouble() != values.intensity();
        boolean isTurned = dome.isEmpty() || !dome.get().rotation().equals(values.rotation());
        if (!isBrightness && !isImage && !isTurned) {
            return;
        }
        UsdLayer.Prim prim = dome.map(d -> layer.prim(d.prim().path())).orElseGet(() -> create.apply(name));
        if (isBrightness) {
            prim.set("float inputs:intensity", UsdLayer.number(values.intensity() * dome.map(UsdPaths.Dome::factor).orElse(1.0)));
        }
        if (isImage) {
            prim.set(UsdPrimWriter.TEXTURE, asset);
            prim.set("token inputs:texture:format", UsdLayer.quoted("latlong"));
        }
        if (isTurned) {
            boolean hasZUp = writer.paths().hasZUp();
            Transform turn = values.rotation().toWorld().times(Transform.rotation(new Vec3(0, -180, 0)));
            if (hasZUp && dome.isPresent() && dome.get().prim().type().equals("DomeLight_1")) {
                turn = turn.times(Transform.rotation(new Vec3(-90, 0, 0)));
            }
            prim.set(UsdLightValues.MATRIX, UsdLightValues.matrix(turn.transformVector(new Vec3(1, 0, 0)),
                    turn.transformVector(new Vec3(0, 0, 1)), Vec3.ZERO, hasZUp));
            prim.set(UsdPrimWriter.ORDER, UsdPrimWriter.RESET_ORDER);
        }
    }
}
