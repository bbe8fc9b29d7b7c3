//! Commands as a user runs them.
mod command;
mod command_accuracy;
mod command_area;
mod command_honest;
mod command_knn;
mod command_process;
mod command_soak;
mod command_vectors;
mod front;
mod package;
mod slurm;
