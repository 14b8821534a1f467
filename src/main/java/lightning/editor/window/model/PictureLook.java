package lightning.editor.window.model;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.editor.document.Command;
import lightning.editor.document.Workbench;
import lightning.editor.loop.Frame;
import lightning.editor.loop.Look;
import lightning.scene.Light;
import lightning.scene.effects.Effect;
import lightning.scene.effects.ViewEffects;

/** What of the traced picture the artist wants to look at: the share of the selected light alone, or less than all effects. */
public final class PictureLook {
    private final SceneEditor editor;
    private final Workbench workbench;
    private final BooleanProperty onlySelected = new SimpleBooleanProperty();
    private final ObjectProperty<ViewEffects> effects = new SimpleObjectProperty<>(ViewEffects.ALL);
    private Look wanted = Look.PLAIN;

    PictureLook(SceneEditor editor, Workbench workbench, Commands commands) {
        this.editor = editor;
        this.workbench = workbench;
        commands.setSwitch(Command.ONLY_SELECTED, onlySelected);
        effect(commands, Command.SHADOWS, e -> e.shows(Effect.SHADOWS), (e, on) -> e.with(Effect.SHADOWS, on));
        effect(commands, Command.REFLECTIONS, e -> e.shows(Effect.REFLECTION), (e, on) -> e.with(Effect.REFLECTION, on));
        effect(commands, Command.LIT_TEXTURES, ViewEffects::litTextures, ViewEffects::withLitTextures);
        onlySelected.subscribe(_ -> look());
        effects.subscribe(_ -> look());
        editor.situationProperty().subscribe(_ -> look());
    }

    private void effect(Commands commands, Command command, Predicate<ViewEffects> shown,
            BiFunction<ViewEffects, Boolean, ViewEffects> with) {
        commands.setSwitch(command, effects.map(shown::test),
                () -> effects.set(with.apply(effects.get(), !shown.test(effects.get()))));
    }

    /** Whether all of the picture is looked at. */
    public boolean isPlain() {
        return wanted.isPlain();
    }

    /** Whether the selected light's share alone is shown, whichever light that is. */
    public BooleanProperty onlySelectedProperty() {
        return onlySelected;
    }

    public ObjectProperty<ViewEffects> effectsProperty() {
        return effects;
    }

    private void look() {
        Light selected = editor.selection().light();
        Look look =
                new Look(onlySelected.get() && selected != null ? Optional.of(renderedName(selected)) : Optional.empty(), effects.get());
        if (!look.equals(wanted)) {
            wanted = look;
            workbench.setLook(look);
        }
    }

    /** A light may have been renamed since the picture was rendered; its place among the lights then tells. */
    private String renderedName(Light light) {
        Frame frame = editor.situationProperty().get().frame().orElse(null);
        List<Light> now = editor.scene().lights();
        boolean renamed = frame != null && frame.scene().light(light.name()).isEmpty() && frame.scene().lights().size() == now.size();
        return renamed ? frame.scene().lights().get(now.indexOf(light)).name() : light.name();
    }
}
