package lightning.editor.window.model;

import java.util.Optional;
import java.util.function.UnaryOperator;
import javafx.beans.property.ObjectProperty;
import lightning.base.text.RefusalException;
import lightning.document.EditOutcome;
import lightning.document.StepRange;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;
import lightning.render.relight.SceneView;
import lightning.scene.Scene;
import lightning.scene.ViewSettings;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Edits of the scene's view transform, and the false colors of the window, which no scene and no preference stores. */
public final class ViewActions {
    /** Exposures that the editor sets, stops. */
    public static final StepRange EXPOSURE_RANGE = new StepRange(0.1, -8, 8);

    private final SceneEditor editor;
    private final TracedPicture picture;

    ViewActions(SceneEditor editor, TracedPicture picture) {
        this.editor = editor;
        this.picture = picture;
    }

    /** View of the traced picture. */
    public ObjectProperty<ViewTransform> viewProperty() {
        return picture.viewProperty();
    }

    /** Sets the scene's curve and ends false colors; or shows false colors without an edit. */
    public void setCurve(DisplayCurve curve) {
        Optional<String> refusal = SceneView.curve(curve).flatMap(c -> edit(view -> view.withCurve(c), null));
        if (refusal.isEmpty()) {
            viewProperty().set(viewProperty().get().withCurve(curve));
        }
    }

    /**
     * Sets the scene's exposure, in stops; returns why it was refused.
     *
     * @param gesture  object that identifies one drag, which is one undo step; null for a separate step
     */
    public Optional<String> setExposure(double stops, @Nullable Object gesture) {
        try {
            SceneLimits.checkRange("exposure", stops, EXPOSURE_RANGE.min(), EXPOSURE_RANGE.max());
        } catch (RefusalException e) {
            return Optional.of(e.getMessage());
        }
        return edit(view -> view.withExposure(stops), gesture);
    }

    private Optional<String> edit(UnaryOperator<ViewSettings> change, @Nullable Object gesture) {
        ViewSettings before = editor.scene().picture().view();
        return change.apply(before).equals(before) ? Optional.empty()
                : editor.editOrReport(scene -> EditOutcome.of(() -> with(scene, change.apply(scene.picture().view()))), gesture);
    }

    private static Scene with(Scene scene, ViewSettings view) {
        return scene.withPicture(scene.picture().withView(view));
    }
}
