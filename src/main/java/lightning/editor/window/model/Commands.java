package lightning.editor.window.model;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import javafx.beans.property.Property;
import javafx.beans.value.ObservableObjectValue;
import javafx.beans.value.ObservableValue;
import lightning.editor.document.Command;
import lightning.editor.document.Situation;

/** What the commands do and switch, and which of them have something to do as things are. */
public final class Commands {
    private final Map<Command, Runnable> actions = new EnumMap<>(Command.class);
    private final Map<Command, ObservableValue<Boolean>> switches = new EnumMap<>(Command.class);
    private final Keys keys = new Keys();
    private final ObservableObjectValue<Situation> situation;
    private final StatusMessage message;

    /** @param message says why a command has nothing to do whose key was pressed */
    Commands(ObservableObjectValue<Situation> situation, StatusMessage message) {
        this.situation = situation;
        this.message = message;
    }

    /** Everything that decides which commands are enabled. */
    public ObservableObjectValue<Situation> situation() {
        return situation;
    }

    /** The keys of the commands. */
    public Keys keys() {
        return keys;
    }

    /** Says what a command does; a pane that asks the artist something first says so for its commands. */
    public void setAction(Command command, Runnable action) {
        actions.put(command, action);
    }

    /** Says that a command switches something, which is seen on its items and buttons. */
    public void setSwitch(Command command, Property<Boolean> on) {
        setSwitch(command, on, () -> on.setValue(!on.getValue()));
    }

    /** The same of something that is switched in another way. */
    public void setSwitch(Command command, ObservableValue<Boolean> on, Runnable action) {
        switches.put(command, on);
        actions.put(command, action);
    }

    /** What a command switches; empty for one that does something else. */
    public Optional<ObservableValue<Boolean>> switched(Command command) {
        return Optional.ofNullable(switches.get(command));
    }

    /** Whether anybody does the command; else it stands for a choice among values. */
    public boolean isDone(Command command) {
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
    public void press(Command command) {
        if (isEnabled(command)) {
            run(command);
        } else if (command != Command.CANCEL) {
            reason(command).ifPresent(why -> message.show(command.plainTitle() + ": " + why));
        }
    }

    public boolean isEnabled(Command command) {
        return command.isEnabled(situation.get());
    }

    /** Why the command is disabled; empty if it is enabled. */
    public Optional<String> reason(Command command) {
        return command.obstacle(situation.get());
    }
}
