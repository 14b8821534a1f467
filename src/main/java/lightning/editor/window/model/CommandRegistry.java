package lightning.editor.window.model;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.property.Property;
import javafx.beans.value.ObservableObjectValue;
import javafx.beans.value.ObservableValue;
import lightning.editor.Command;
import lightning.editor.EditorState;

/** Actions, toggle states and enablement of the editor's commands. */
public final class CommandRegistry {
    private final Map<Command, Runnable> actions = new EnumMap<>(Command.class);
    private final Map<Command, ObservableValue<Boolean>> toggleStates = new EnumMap<>(Command.class);
    private final KeyBindings keyBindings = new KeyBindings();
    private final ObservableObjectValue<EditorState> editorState;
    private final StatusMessage message;
    private final List<Consumer<Command>> runListeners = new ArrayList<>();

    /** @param message  shows why a command is disabled when its key is pressed */
    CommandRegistry(ObservableObjectValue<EditorState> editorState, StatusMessage message) {
        this.editorState = editorState;
        this.message = message;
    }

    /** Returns the state that decides which commands are enabled. */
    public ObservableObjectValue<EditorState> editorState() {
        return editorState;
    }

    /** Returns the keys of the commands. */
    public KeyBindings keyBindings() {
        return keyBindings;
    }

    /** Sets the action of a command. A pane that prompts the user first registers its commands itself. */
    public void setAction(Command command, Runnable action) {
        actions.put(command, action);
    }

    /** Makes a command toggle a property, whose value its items and buttons show. */
    public void setToggle(Command command, Property<Boolean> state) {
        setToggle(command, state, () -> state.setValue(!state.getValue()));
    }

    /** Makes a command a toggle with an action of its own. */
    public void setToggle(Command command, ObservableValue<Boolean> state, Runnable action) {
        toggleStates.put(command, state);
        actions.put(command, action);
    }

    /** Returns the state that a command toggles, or empty if it toggles none. */
    public Optional<ObservableValue<Boolean>> toggleState(Command command) {
        return Optional.ofNullable(toggleStates.get(command));
    }

    /** Returns whether the command has an action. A command without one stands for a choice among values. */
    public boolean hasAction(Command command) {
        return actions.containsKey(command);
    }

    /** Runs the command if it is enabled and has an action. */
    public void run(Command command) {
        Runnable action = actions.get(command);
        if (action != null && isEnabled(command)) {
            action.run();
            List.copyOf(runListeners).forEach(listener -> listener.accept(command));
        }
    }

    /** Adds a listener that is called after each run of a command. */
    public void addRunListener(Consumer<Command> listener) {
        runListeners.add(listener);
    }

    public void removeRunListener(Consumer<Command> listener) {
        runListeners.remove(listener);
    }

    /** Runs a command whose key was pressed, or shows why it is disabled. {@link Command#CANCEL} shows nothing. */
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

    /** Returns why the command is disabled, or empty if it is enabled. */
    public Optional<String> disabledReason(Command command) {
        return command.disabledReason(editorState.get());
    }
}
