package lightning.editor.window.model;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.document.loop.DisplayMode;
import lightning.document.loop.Frame;
import lightning.editor.Command;
import lightning.editor.Workbench;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Light;

/** Display settings of the traced picture: the contribution of the selected light alone, or a subset of the effects. */
public final class PictureDisplay {
    private final SceneEditor editor;
    private final Workbench workbench;
    private final BooleanProperty onlySelected = new SimpleBooleanProperty();
    private final ObjectProperty<ViewEffects> effects = new SimpleObjectProperty<>(ViewEffects.ALL);
    private DisplayMode mode = DisplayMode.FULL_PICTURE;

    PictureDisplay(SceneEditor editor, Workbench workbench, CommandRegistry commands) {
        this.editor = editor;
        this.workbench = workbench;
        commands.setToggle(Command.ONLY_SELECTED, onlySelected);
        addToggle(commands, Command.SHADOWS, e -> e.shows(RenderEffect.SHADOWS), (e, on) -> e.with(RenderEffect.SHADOWS, on));
        addToggle(commands, Command.REFLECTIONS, e -> e.shows(RenderEffect.REFLECTION), (e, on) -> e.with(RenderEffect.REFLECTION, on));
        addToggle(commands, Command.LIT_TEXTURES, ViewEffects::litTextures, ViewEffects::withLitTextures);
        onlySelected.subscribe(_ -> update());
        effects.subscribe(_ -> update());
        editor.editorStateProperty().subscribe(_ -> update());
    }

    private void addToggle(CommandRegistry commands, Command command, Predicate<ViewEffects> isShown,
            BiFunction<ViewEffects, Boolean, ViewEffects> withShown) {
        commands.setToggle(command, effects.map(isShown::test),
                () -> effects.set(withShown.apply(effects.get(), !isShown.test(effects.get()))));
    }

    /** Returns whether the complete picture is shown. */
    public boolean isFullPicture() {
        return mode.isFullPicture();
    }

    public ObjectProperty<ViewEffects> effectsProperty() {
        return effects;
    }

    private void update() {
        Light selected = editor.selection().light();
        DisplayMode newMode =
                new DisplayMode(onlySelected.get() && selected != null ? Optional.of(renderedName(selected)) : Optional.empty(),
                        effects.get());
        if (!newMode.equals(mode)) {
            mode = newMode;
            workbench.setDisplayMode(newMode);
        }
    }

    /** Returns the light's name in the rendered frame. A light renamed since then is found by its index. */
    private String renderedName(Light light) {
        Frame frame = editor.editorStateProperty().get().frame().orElse(null);
        List<Light> lights = editor.scene().lights();
        boolean isRenamed = frame != null && frame.scene().light(light.name()).isEmpty() && frame.scene().lights().size() == lights.size();
        return frame != null && isRenamed ? frame.scene().lights().get(lights.indexOf(light)).name() : light.name();
    }
}
