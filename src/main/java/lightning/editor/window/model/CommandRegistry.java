package lightning.editor.window.model;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import javafx.beans.property.Property;
import javafx.beans.value.ObservableObjectValue;
import javafx.beans.value.ObservableValue;
import lightning.editor.document.Command;
import lightning.editor.document.EditorState;

/** What the commands do and switch, and which of them have something to do as things are. */
public final class CommandRegistry {
    private final Map<Command, Runnable> actions = new EnumMap<>(Command.class);
    private final Map<Command, ObservableValue<Boolean>> toggleStates = new EnumMap<>(Command.class);
    private final KeyBindings keyBindings = new KeyBindings();
    private final ObservableObjectValue<EditorState> editorState;
    private final StatusMessage message;

    /** @param message says why a command has nothing to do whose key was pressed */
    CommandRegistry(ObservableObjectValue<EditorState> editorState, StatusMessage message) {
        this.editorState = editorState;
        this.message = message;
    }

    /** Everything that decides which commands are enabled. */
    public ObservableObjectValue<EditorState> editorState() {
        return editorState;
    }

    /** The keys of the commands. */
    public KeyBindings keyBindings() {
        return keyBindings;
    }

    /** Says what a command does; a pane that asks the artist something first says so for its commands. */
    public void setAction(Command command, Runnable action) {
        actions.put(command, action);
    }

    /** Says that a command switches something, which is seen on its items and buttons. */
    public void setToggle(Command command, Property<Boolean> state) {
        setToggle(command, state, () -> state.setValue(!state.getValue()));
    }

    /** The same of something that is switched in another way. */
    public void setToggle(Command command, ObservableValue<Boolean> state, Runnable action) {
        toggleStates.put(command, state);
        actions.put(command, action);
    }

    /** What a command switches; empty for one that does something else. */
    public Optional<ObservableValue<Boolean>> toggleState(Command command) {
        return Optional.ofNullable(toggleStates.get(command));
    }

    /** Whether anybody does the command; else it stands for a choice among values. */
    public boolean hasAction(Command command) {
        return actions.containsKey(command);
    }

    /** Does the command if it is enabled, and anybody does it. */
    public void run(Command command) {
        Runnable action = actions.get(command);
        if (action != null && isEnabled(command)) {
            action.run();
        }
    }

    /** A command's key was pressed: does it, or says why there is nothing to do; to cancel nothing needs no words. */
    public void runOrExplain(Command command) {
        if (isEnabled(command)) {
            run(command);
        } else if (command != Command.CANCEL) {
            disabledReason(command).ifPresent(reason -> message.show(command.plainTitle() + ": " + reason));
        }
    }

    public boolean isEnabled(Command command) {
        return command.isEnabled(editorState.get());
    }

    /** Why the command is disabled; empty if it is enabled. */
    public Optional<String> disabledReason(Command command) {
        return command.disabledReason(editorState.get());
    }
}
