package lightning.cli.output;

import java.util.Optional;
import lightning.format.jen.InputFiles;
import lightning.render.image.ViewTransform;
import lightning.render.relight.SceneView;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Option for the view transform of a displayed picture. */
public final class ViewOption {
    @Option(names = "--view", paramLabel = "VIEW", converter = ViewConverter.class,
            description = "View transform of displayed pictures: srgb, 1998 (linear, no curve), filmic, aces, aces2 or agx (highlight roll-off), "
                    + "false (false color, one color per stop), a .cube LUT, a transform with a LUT: filmic+look.cube, a logarithm with a "
                    + "LUT: log2:-10,6.5+look.cube, or a view of OpenColorIO: ocio:DISPLAY/VIEW or ocio:config.ocio#DISPLAY/VIEW "
                    + "(default: the scene's).")
    private @Nullable ViewChoice view;

    /** Returns whether the option was used. */
    public boolean isChosen() {
        return view != null;
    }

    /** Returns the view transform of a scene's picture: the option's with the scene's exposure, else the scene's. */
    public ViewTransform of(Scene scene) {
        ViewTransform ofScene = SceneView.of(scene);
        return view == null ? ofScene : view.transform().withExposure(ofScene.exposure());
    }

    /** Adds the lookup table of the view to the files that the command reads. */
    public InputFiles withFile(InputFiles inputs) {
        return Optional.ofNullable(view).flatMap(v -> v.transform().lut()).map(lut -> inputs.with(lut.file())).orElse(inputs);
    }

    /** Prints what there is to say about the accuracy of the view. */
    public void printNotes(Console console) {
        if (view != null) {
            view.notes().forEach(note -> console.warn("%s", note));
        }
    }
}
