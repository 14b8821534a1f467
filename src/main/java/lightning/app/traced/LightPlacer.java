package lightning.app.traced;

import java.util.function.BiFunction;
import java.util.function.Consumer;
import lightning.app.model.EditorModel;
import lightning.edit.Change;
import lightning.edit.Command;
import lightning.edit.LightEdits;
import lightning.edit.LightPlacing;
import lightning.edit.ScenePicker;
import lightning.scene.Scene;

/** Places the selected light by what it does in the traced picture: its aim, its highlight, the shadow of something. */
final class LightPlacer {
    private final EditorModel model;
    private final Picker picker;

    /** Lets the artist click a place of the traced picture. */
    interface Picker {
        /** @param picked hears what is there, never the background */
        void next(String hint, Consumer<PixelReport> picked);
    }

    private LightPlacer(EditorModel model, Picker picker) {
        this.model = model;
        this.picker = picker;
    }

    /** Does the commands that place a light. */
    static void addTo(EditorModel model, Picker picker) {
        var placer = new LightPlacer(model, picker);
        model.setAction(Command.AIM, placer::aim);
        model.setAction(Command.PLACE_HIGHLIGHT, placer::highlight);
        model.setAction(Command.PLACE_SHADOW, placer::shadow);
    }

    private void aim() {
        picker.next("Click where the light should shine to", at -> edit((scene, light) -> LightEdits.aim(scene, light, at.point())));
    }

    private void highlight() {
        picker.next("Click where the highlight should be", at -> edit((scene, light) -> LightPlacing.highlight(scene, light, found(at))));
    }

    private void shadow() {
        picker.next("Click what throws the shadow", thrower -> picker.next("Click where the shadow should fall",
                target -> edit((scene, light) -> LightPlacing.shadow(scene, light, thrower.point(), target.point()))));
    }

    private ScenePicker.Found found(PixelReport at) {
        return new ScenePicker.Found(at.shape(), at.point(), at.normal(), model.scene().camera().from());
    }

    private void edit(BiFunction<Scene, String, Change> edit) {
        if (model.selectedLight() == null) {
            model.say("No light is selected");
        } else {
            String light = model.selectedLight().name();
            model.edit(scene -> edit.apply(scene, light)).ifPresent(model::say);
        }
    }
}
