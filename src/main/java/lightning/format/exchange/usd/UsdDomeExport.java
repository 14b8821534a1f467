package lightning.format.exchange.usd;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Supplier;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.jen.asset.FileKind;
import lightning.format.mesh.ConversionNotes;
import lightning.format.usd.UsdLayer;
import lightning.scene.World;

/**
 * Writer of what has been edited of the environment.
 *
 * @param layer receives the edits
 * @param writer writer of single attributes
 * @param notes receives what cannot be written
 */
public record UsdDomeExport(UsdLayer layer, UsdPrimWriter writer, ConversionNotes notes) {
    /**
     * Writes the edits; removes the dome light if the scene has no environment.
     *
     * @param create defines a dome light if the stage has none
     */
    public void add(World world, Supplier<UsdLayer.Prim> create) throws IOException {
        Optional<UsdPaths.Dome> dome = writer.paths().dome();
        if (world.environment().isEmpty()) {
            dome.ifPresent(d -> layer.prim(d.prim().path()).metadata("active", "false"));
            return;
        }
        if (world.sky().on()) {
            notes.add("physical skies");
            return;
        }
        notes.add("light gain of the environment", world.gain() == 1 ? 0 : 1);
        String file = world.environment().get().file();
        boolean isBrightness =
                dome.isEmpty() || dome.get().intensity().isEmpty() || dome.get().intensity().getAsDouble() != world.intensity();
        boolean isImage = dome.isEmpty() || !writer.paths().isSameFile(dome.get().file(), file);
        boolean isTurned = dome.isEmpty() || !dome.get().rotation().equals(world.dome());
        if (!isBrightness && !isImage && !isTurned) {
            return;
        }
        UsdLayer.Prim prim = dome.map(d -> layer.prim(d.prim().path())).orElseGet(create);
        if (isBrightness) {
            prim.set("float inputs:intensity", UsdLayer.number(world.intensity() * dome.map(UsdPaths.Dome::factor).orElse(1.0)));
        }
        if (isImage) {
            prim.set(UsdPrimWriter.TEXTURE, writer.asset(FileKind.ENVIRONMENT, file));
            prim.set("token inputs:texture:format", UsdLayer.quoted("latlong"));
        }
        if (isTurned) {
            boolean hasZUp = writer.paths().hasZUp();
            Transform turn = world.dome().toWorld().times(Transform.rotation(new Vec3(0, -180, 0)));
            if (hasZUp && dome.isPresent() && dome.get().prim().type().equals("DomeLight_1")) {
                turn = turn.times(Transform.rotation(new Vec3(-90, 0, 0)));
            }
            prim.set(UsdLightValues.MATRIX, UsdLightValues.matrix(turn.transformVector(new Vec3(1, 0, 0)),
                    turn.transformVector(new Vec3(0, 0, 1)), Vec3.ZERO, hasZUp));
            prim.set(UsdPrimWriter.ORDER, UsdPrimWriter.RESET_ORDER);
        }
    }
}
