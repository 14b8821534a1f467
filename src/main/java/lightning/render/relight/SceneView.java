package lightning.render.relight;

import java.util.Optional;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import lightning.scene.ViewCurve;
import lightning.scene.ViewSettings;

/** Conversion of a scene's view settings to a view transform. */
public final class SceneView {
    private SceneView() {}

    /** Returns the view transform of a scene. */
    public static ViewTransform of(Scene scene) {
        ViewSettings settings = scene.picture().view();
        return new ViewTransform(settings.exposure(), of(settings.curve()));
    }

    public static DisplayCurve of(ViewCurve curve) {
        return switch (curve) {
            case SRGB -> DisplayCurve.SRGB;
            case LINEAR -> DisplayCurve.LINEAR;
            case FILMIC -> DisplayCurve.FILMIC;
            case ACES -> DisplayCurve.ACES;
            case ACES2 -> DisplayCurve.ACES2;
            case AGX -> DisplayCurve.AGX;
        };
    }

    /** Returns the scene's curve that is shown by a display curve; empty for false colors, which no scene stores. */
    public static Optional<ViewCurve> curve(DisplayCurve shown) {
        return switch (shown) {
            case SRGB -> Optional.of(ViewCurve.SRGB);
            case LINEAR -> Optional.of(ViewCurve.LINEAR);
            case FILMIC -> Optional.of(ViewCurve.FILMIC);
            case ACES -> Optional.of(ViewCurve.ACES);
            case ACES2 -> Optional.of(ViewCurve.ACES2);
            case AGX -> Optional.of(ViewCurve.AGX);
            case FALSE -> Optional.empty();
        };
    }
}
